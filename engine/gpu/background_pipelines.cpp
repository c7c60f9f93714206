#include "engine/gpu/background_pipelines.h"

#include <sys/resource.h>

#include <algorithm>
#include <optional>

#include "engine/core/check.h"
#include "engine/core/clock.h"
#include "engine/core/error.h"
#include "engine/core/log.h"
#include "engine/gpu/acceleration_structure.h"
#include "engine/gpu/device.h"
#include "engine/gpu/driver_cache.h"
#include "engine/gpu/resource.h"

namespace vamp::gpu {
namespace {

// What is spare yields to the device's own threads.
constexpr int kSpareNice = 5;

// The cache's writer has the least priority on a busy machine.
constexpr double kPatienceSeconds = 1;
constexpr int kUnseenAllowed = 4;

}  // namespace

// A second device, and something for each binding that has the right format.
class BackgroundPipelines::Rehearsal {
 public:
  Rehearsal(const Device& like, const std::vector<std::pair<Binding, VkFormat>>& formats) {
    auto made = like.sibling();
    if (!made) throw MachineError(made.error().kind, made.error().message());
    device_ = std::move(*made);
    Usage any = Usage::storage | Usage::uniform | Usage::uniform_texel | Usage::storage_texel;
    if (device_->info().ray_queries) any = any | Usage::ray_input;
    buffer_ = Buffer(*device_, {.name = "rehearsal", .bytes = 4096, .usage = any});
    std::vector<Bound> bound;
    std::vector<Binding> bindings;
    views_.reserve(formats.size());
    for (const auto& [binding, format] : formats) {
      bindings.push_back(binding);
      if (binding.type == BindingType::acceleration_structure) {
        if (!rays_) rays_ = AccelerationStructure(*device_, "rehearsal", buffer_, 1);
        bound.emplace_back(binding.binding, rays_);
      } else if (format == VK_FORMAT_UNDEFINED) {
        bound.emplace_back(binding.binding, buffer_);
      } else {
        views_.emplace_back(*device_, buffer_, format);
        bound.emplace_back(binding.binding, views_.back());
      }
    }
    set_ = DescriptorSet(*device_, "rehearsal", bindings, bound);
    CommandList list = device_->begin("rehearsal");
    list.fill(buffer_, 0);
    device_->submit(std::move(list));
    list = device_->begin("rehearsal");
    if (rays_) list.build(rays_);
    device_->wait(device_->submit(std::move(list)));
  }

  // Whether the driver had the code already. Constants of 0: kernels find that there is nothing to do.
  bool run(const PipelineDesc& desc) {
    const Clock::time_point begin = Clock::now();
    const ComputePipeline twin(*device_, desc);
    const double making = seconds_since(begin);
    const std::vector<std::byte> zero(desc.push_bytes);
    CommandList list = device_->begin("rehearsal");
    list.bind(twin, set_);
    list.push_bytes(zero.data(), desc.push_bytes);
    list.dispatch(1);
    const Clock::time_point start = Clock::now();
    device_->wait(device_->submit(std::move(list)));
    // Compiling takes two to fifteen times as long as making the pipeline, finding the code a tenth of it.
    return seconds_since(start) < making;
  }

 private:
  std::unique_ptr<Device> device_;
  Buffer buffer_;
  std::vector<TexelView> views_;
  AccelerationStructure rays_;
  DescriptorSet set_;
};

bool BackgroundPipelines::useful(const Device& device) {
  return !device.info().is_lavapipe || !driver_caches().empty();
}

BackgroundPipelines::BackgroundPipelines(Device& device, std::function<void()> arrived)
    : device_(device),
      arrived_(std::move(arrived)),
      caches_(device.info().is_lavapipe ? driver_caches() : std::vector<fs::path>()) {
  threads_.emplace_back([this] { work(device_.nice(), false); });
  threads_.emplace_back([this] { work(device_.nice() + kSpareNice, true); });
}

BackgroundPipelines::~BackgroundPipelines() {
  {
    const std::scoped_lock lock(mutex_);
    stop_ = true;
  }
  wanted_.notify_all();
  for (std::thread& thread : threads_) thread.join();
}

void BackgroundPipelines::bound_as(const std::vector<Binding>& bindings, const std::vector<Bound>& bound) {
  std::vector<std::pair<Binding, VkFormat>> formats;
  for (const Binding& binding : bindings) {
    const auto at =
        std::find_if(bound.begin(), bound.end(), [&](const Bound& b) { return b.binding == binding.binding; });
    CHECK(at != bound.end());
    formats.emplace_back(binding, at->view != nullptr ? at->view->state()->format : VK_FORMAT_UNDEFINED);
  }
  {
    const std::scoped_lock lock(mutex_);
    if (!formats_.empty()) return;
    formats_ = std::move(formats);
  }
  wanted_.notify_all();
}

void BackgroundPipelines::want(Number number, const PipelineDesc& desc, Urgency urgency) {
  {
    const std::scoped_lock lock(mutex_);
    jobs_.push_back({number, desc, urgency});
  }
  wanted_.notify_all();
}

void BackgroundPipelines::raise(Number number, Urgency urgency) {
  {
    const std::scoped_lock lock(mutex_);
    const auto job = std::find_if(jobs_.begin(), jobs_.end(), [&](const Job& j) { return j.number == number; });
    if (job == jobs_.end() || job->urgency <= urgency) return;
    job->urgency = urgency;
    // Behind those that asked for as much before.
    std::rotate(job, job + 1, jobs_.end());
  }
  wanted_.notify_all();
}

std::vector<BackgroundPipelines::Number> BackgroundPipelines::drop_wanted() {
  const std::scoped_lock lock(mutex_);
  std::vector<Number> dropped;
  for (const Job& job : std::exchange(jobs_, {})) dropped.push_back(job.number);
  return dropped;
}

std::vector<std::pair<BackgroundPipelines::Number, ComputePipeline>> BackgroundPipelines::take() {
  const std::scoped_lock lock(mutex_);
  if (error_) std::rethrow_exception(error_);
  return std::exchange(made_, {});
}

void BackgroundPipelines::wait() {
  std::unique_lock lock(mutex_);
  // Whoever waits for several can as well make one of them.
  const auto job =
      std::find_if(jobs_.begin(), jobs_.end(), [](const Job& j) { return j.urgency == Urgency::straight; });
  if (made_.empty() && !error_ && job != jobs_.end()) {
    const Job mine = std::move(*job);
    jobs_.erase(job);
    lock.unlock();
    ComputePipeline pipeline(device_, mine.desc);
    lock.lock();
    made_.emplace_back(mine.number, std::move(pipeline));
  }
  made_one_.wait(lock, [this] { return !made_.empty() || error_; });
}

bool BackgroundPipelines::pick(bool spare, Job& job) {
  auto best = jobs_.end();
  for (auto at = jobs_.begin(); at != jobs_.end(); ++at) {
    // The thread for what is spare would let those wait who wait already.
    if (at->urgency == (spare ? Urgency::straight : Urgency::spare)) continue;
    if (at->urgency != Urgency::straight && !caches_.empty() && formats_.empty()) continue;
    if (best == jobs_.end() || at->urgency < best->urgency) best = at;
  }
  if (best == jobs_.end()) return false;
  job = std::move(*best);
  jobs_.erase(best);
  return true;
}

void BackgroundPipelines::rehearse(std::unique_ptr<Rehearsal>& rehearsal, const PipelineDesc& desc) {
  std::vector<std::pair<Binding, VkFormat>> formats;
  {
    const std::scoped_lock lock(mutex_);
    if (unseen_ > kUnseenAllowed) return;
    formats = formats_;
  }
  const fs::file_time_type before = last_change(caches_);
  try {
    if (!rehearsal) rehearsal = std::make_unique<Rehearsal>(device_, formats);
    if (rehearsal->run(desc)) return;
  } catch (const MachineError& error) {
    // No memory for a second device, say: the first one does without.
    spdlog::info("kernels are compiled while the picture waits: {}", error.what());
    rehearsal.reset();
    const std::scoped_lock lock(mutex_);
    unseen_ = kUnseenAllowed + 1;
    return;
  }
  const Clock::time_point start = Clock::now();
  bool seen = false, stopped = false;
  while (!seen && !stopped && seconds_since(start) < kPatienceSeconds) {
    std::this_thread::sleep_for(std::chrono::milliseconds(3));
    seen = last_change(caches_) != before;
    const std::scoped_lock lock(mutex_);
    stopped = stop_;
  }
  const std::scoped_lock lock(mutex_);
  if (stopped) return;
  unseen_ = seen ? 0 : unseen_ + 1;
  if (unseen_ == kUnseenAllowed + 1)
    spdlog::info("kernels are compiled while the picture waits: nothing appears in {}", caches_.front().string());
}

void BackgroundPipelines::work(int nice, bool spare) {
  setpriority(PRIO_PROCESS, 0, nice);  // of this thread alone: Linux counts threads as processes here
  std::unique_ptr<Rehearsal> rehearsal;
  Job job;
  while (true) {
    {
      std::unique_lock lock(mutex_);
      wanted_.wait(lock, [&] { return stop_ || pick(spare, job); });
      if (stop_) return;
    }
    std::exception_ptr error;
    ComputePipeline pipeline;
    try {
      if (job.urgency != Urgency::straight && !caches_.empty()) rehearse(rehearsal, job.desc);
      pipeline = ComputePipeline(device_, job.desc);
    } catch (...) {
      error = std::current_exception();
    }
    {
      const std::scoped_lock lock(mutex_);
      if (error)
        error_ = error;
      else
        made_.emplace_back(job.number, std::move(pipeline));
    }
    made_one_.notify_all();
    if (arrived_) arrived_();
    if (error) return;
  }
}

}  // namespace vamp::gpu
