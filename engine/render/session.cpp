#include "engine/render/session.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <optional>
#include <thread>

#include "engine/core/clock.h"
#include "engine/core/log.h"
#include "engine/gpu/device.h"
#include "engine/render/goal.h"
#include "engine/render/pick.h"
#include "engine/render/renderer.h"
#include "engine/render/shown_picture.h"

namespace vamp {
namespace {

// What edits may be answered from, for both together: at 640 x 480 the hits of some 270 samples (see
// Renderer::set_history) and the sums of all directions.
constexpr uint64_t kHistoryBytes = 160u << 20, kWeightBytes = 256u << 20;

// So many samples are shaded again before a newer edit is looked for: some 10 ms on two cores of lavapipe. Of what is
// done while nothing is asked for, some 3 ms.
constexpr uint32_t kReplaySamples = 1u << 16, kGatheredSamples = 1u << 14;

// A window's frame takes 4 ms where nothing else computes, and twice to four times as long beside the next samples.
constexpr std::chrono::milliseconds kShowing(12);

// A hand that drags a part rests when it has not moved for so long: then there is time for a new tree.
constexpr std::chrono::milliseconds kRest{100};

}  // namespace

class RenderSession::Impl {
 public:
  Impl(gpu::Device& device, std::shared_ptr<const Project> project, int width, int height, uint64_t edit_memory,
       Kernels kernels)
      : device_(device), renderer_(device), next_project_(std::move(project)), next_size_(ivec2(width, height)) {
    status_.device = device.info().name;
    constexpr uint64_t kAll = kHistoryBytes + kWeightBytes;
    if (edit_memory == kAutomaticMemory) edit_memory = std::min(device.info().memory_bytes / 16, kAll);
    const uint64_t history = edit_memory / kAll * kHistoryBytes + edit_memory % kAll * kHistoryBytes / kAll;
    renderer_.set_history(history);
    renderer_.set_weight_memory(edit_memory - history);
    renderer_.make_trees_later();
    if (kernels == Kernels::in_background)
      renderer_.make_kernels_in_background([this] {
        const std::lock_guard lock(mutex_);
        kernels_arrived_ = true;
        wake_.notify_all();
      });
    thread_ = std::thread([this] { run(); });
  }

  ~Impl() {
    {
      const std::lock_guard lock(mutex_);
      stop_ = true;
    }
    wake_.notify_all();
    thread_.join();
  }

  void set_project(std::shared_ptr<const Project> project, std::string reason) {
    {
      const std::lock_guard lock(mutex_);
      next_project_ = std::move(project);
      // Several edits may arrive between two tiles: the last one's reason stands for them.
      if (!reason.empty()) next_reason_ = std::move(reason);
    }
    wake_.notify_all();
  }

  void resize(int width, int height) {
    {
      const std::lock_guard lock(mutex_);
      next_size_ = ivec2(std::max(width, 1), std::max(height, 1));
    }
    wake_.notify_all();
  }

  void pause(bool paused) {
    {
      const std::lock_guard lock(mutex_);
      paused_ = paused;
    }
    wake_.notify_all();
  }

  void when_answered(std::function<void()> answered) {
    const std::lock_guard lock(mutex_);
    answered_ = std::move(answered);
  }

  void picture_shown(uint64_t version) {
    {
      const std::lock_guard lock(mutex_);
      if (version < awaits_showing_ || awaits_showing_ == 0) return;
      awaits_showing_ = 0;
    }
    wake_.notify_all();
  }

  void lose_device() {
    {
      const std::lock_guard lock(mutex_);
      lose_device_ = true;
    }
    wake_.notify_all();
  }

  RenderStatus status() const {
    const std::lock_guard lock(mutex_);
    return status_;
  }

  const ShownPicture& shown() const { return shown_; }

  void set_weights_at_hand(const WeightGroup& group) {
    {
      const std::lock_guard lock(mutex_);
      if (group == asked_group_) return;
      asked_group_ = group;
      next_group_ = group;
    }
    wake_.notify_all();
  }

  std::vector<float> linear_picture(int& width, int& height, uint32_t& samples) const {
    // The render thread lets waiting readers in between two tiles.
    readers_.fetch_add(1);
    const std::lock_guard lock(renderer_mutex_);
    readers_.fetch_sub(1);
    width = renderer_.region().width;
    height = renderer_.region().height;
    samples = renderer_.replayed_samples();
    if (width == 0) return {};
    return renderer_.linear_picture(device_.last_submitted());
  }

 private:
  void run() {
    try {
      while (step()) {
      }
    } catch (const MachineError& error) {
      spdlog::error("{}", error.what());
      const std::lock_guard lock(mutex_);
      status_.error = error.what();
      status_.lost = true;
    } catch (const std::exception& error) {
      // Above all the computer's memory: the picture stops, the document stays.
      spdlog::error("the renderer stopped: {}", error.what());
      const std::lock_guard lock(mutex_);
      status_.error = std::string("the renderer stopped: ") + error.what();
      status_.lost = true;
    }
  }

  // One round: take over what was asked for, refine one tile, show it. False: stop.
  bool step() {
    std::shared_ptr<const Project> offered, project;
    std::optional<ivec2> size;
    std::optional<WeightGroup> group;
    std::string reason;
    {
      std::unique_lock lock(mutex_);
      wait_for_work(lock);
      if (stop_) return false;
      if (lose_device_) throw MachineError(ErrorKind::device_lost, "the device was lost on request");
      kernels_arrived_ = false;
      offered = next_project_;
      size = std::exchange(next_size_, std::nullopt);
      group = std::exchange(next_group_, std::nullopt);
    }
    // Kernels are not for readers of the picture: no lock.
    renderer_.take_kernels();
    if (offered && may_take(offered, size.has_value())) {
      const std::lock_guard lock(mutex_);
      // A newer one is looked at in the next round.
      if (next_project_ == offered) {
        project = std::exchange(next_project_, nullptr);
        reason = std::exchange(next_reason_, "");
      }
    }
    while (readers_.load() > 0) std::this_thread::sleep_for(std::chrono::microseconds(50));
    const std::lock_guard lock(renderer_mutex_);
    if (group) renderer_.set_weights_at_hand(*group);
    if (project) take_project(std::move(project), reason);
    if (size) take_size(*size);
    work();
    busy_ = !refused_ && renderer_.region().width > 0 && (wants_preview_ || renderer_.replaying() || wants_weights());
    const std::lock_guard state(mutex_);
    status_.weights_at_hand = renderer_.weights_ready();
    return true;
  }

  void wait_for_work(std::unique_lock<std::mutex>& lock) {
    if (awaits_showing_ > 0)
      wake_.wait_for(lock, kShowing, [&] { return awaits_showing_ == 0 || stop_ || lose_device_ || next_project_; });
    awaits_showing_ = 0;
    const auto asked = [&] {
      const bool offers = next_project_ && next_project_ != waits_for_kernels_;
      return stop_ || lose_device_ || offers || next_size_ || next_group_ || kernels_arrived_;
    };
    if (rests_before_tree())
      wake_.wait_until(lock, taken_ + kRest, asked);
    else
      wake_.wait(lock, [&] { return asked() || (!refused_ && (busy_.load() || (!paused_ && !finished_.load()))); });
  }

  bool may_take(const std::shared_ptr<const Project>& project, bool resized) {
    // A drag sends edits faster than a large material is shaded: each of them gets its first whole picture.
    if (owes_picture_ && renderer_.replaying() && !resized) return false;
    // Until its kernels are there, the picture before goes on.
    const bool has_kernels = renderer_.has_kernels_for(*project);
    waits_for_kernels_ = has_kernels ? nullptr : project;
    return has_kernels;
  }

  // What is most wanted, a tile or some 10 ms of it; a new tree takes longer, and comes when nothing was moved for a
  // while.
  void work() {
    if (refused_ || renderer_.region().width == 0) return;
    if (std::exchange(wants_preview_, false)) return answer(renderer_.preview(preview_stride()));
    if (renderer_.wants_tree()) {
      if (Clock::now() >= taken_ + kRest) make_tree();
      return;
    }
    if (renderer_.replaying()) return shade_again();
    if (wants_weights()) {
      device_.wait(renderer_.gather_weights(finished_, kGatheredSamples));
      return;
    }
    {
      // What is paused is refinement; an edit is shown.
      const std::lock_guard state(mutex_);
      if (paused_) return;
    }
    if (!finished_) refine_tile();
  }

  // The first look is there, and what follows needs a new tree.
  bool rests_before_tree() const {
    return !refused_ && !wants_preview_ && renderer_.region().width > 0 && renderer_.wants_tree();
  }

  void make_tree() {
    const Status made = renderer_.make_tree();
    if (!made) refuse(made.error());
    pass_start_ = Clock::now();
  }

  void refuse(const Error& error) {
    spdlog::error("{}", error.message());
    refused_ = true;
    const std::lock_guard lock(mutex_);
    status_.error = error.message();
  }

  // Sums for the weights at hand come before more samples, for single channels after them.
  bool wants_weights() const { return cursor_ == 0 && renderer_.wants_weights(finished_); }

  void take_project(std::shared_ptr<const Project> project, const std::string& reason) {
    const Result<Change> change = renderer_.set_project(project);
    if (!change) return refuse(change.error());
    refused_ = false;
    shown_.draw(project, renderer_);
    if (change->restarted && change->places_moved) shown_.forget_ids();
    if (change->restarted) restart(reason.empty() ? change->what : reason);
    if (change->reshaded > 0) begin_shading_again(reason.empty() ? change->what : reason, *change);
    if (renderer_.wants_tree()) {
      // An edit while there is no sample of the moved parts yet is seen in another first look.
      wants_preview_ = true;
      if (change->restarted) taken_ = Clock::now();
    }
    const bool kept = !change->restarted && change->reshaded == 0;
    if ((change->recomposed || change->recombined > 0) && renderer_.region().width > 0) {
      goal_.forget_picture();
      answer(change->recomposed ? renderer_.recompose() : renderer_.last_submitted());
      if (kept) shown_.set_restarted({});
    }
    finished_ = renderer_.region().width > 0 && !renderer_.replaying() && reached();
    const std::lock_guard lock(mutex_);
    // Light, exposure and weights at hand are a matter of sums that are there: no pixel lost its samples.
    if ((change->recomposed || change->recombined > 0) && kept && !reason.empty()) {
      status_.restart_reason = reason;
      status_.restarted_pixels = 0;
    }
    if (change->restarted || change->reshaded > 0 || change->recomposed || change->recombined > 0)
      status_.recombined_pixels = change->recombined;
    status_.project = std::move(project);
    status_.error.clear();
    status_.finished = finished_;
    if (change->bytes > 0) status_.bytes_uploaded = change->bytes;
  }

  void take_size(ivec2 size) {
    if (size == ivec2(renderer_.region().width, renderer_.region().height)) return;
    const bool first = renderer_.region().width == 0;
    // Then the picture stays as large as it was.
    const Status fits = renderer_.region_fits(size.x, size.y);
    {
      const std::lock_guard lock(mutex_);
      if (!fits) status_.error = fits.error().message();
      if (fits && !refused_) status_.error.clear();
    }
    if (!fits) return;
    renderer_.set_region(size.x, size.y, {0, 0, size.x, size.y});
    shown_.resize(size.x, size.y);
    restart(first ? "opened" : "window resized");
  }

  void restart(const std::string& reason) {
    cursor_ = 0;
    pass_whole_ = true;
    wants_preview_ = true;
    owes_picture_ = false;
    finished_ = false;
    start_ = Clock::now();
    pass_start_ = start_;
    goal_.restart(renderer_);
    forget_ids();
    shown_.set_all_restarted();
    const std::lock_guard lock(mutex_);
    status_.restart_reason = reason;
    status_.samples = 0;
    status_.seconds = 0;
    status_.noise = -1;
    status_.finished = false;
    status_.restarted_pixels =
        static_cast<uint64_t>(renderer_.region().width) * static_cast<uint64_t>(renderer_.region().height);
  }

  // A look that is due within a frame: the whole picture follows a moving camera, and tiles take its place when it
  // rests.
  uint32_t preview_stride() const {
    constexpr double kFrame = 20;  // ms
    const double sample = pass_ms_.empty() ? 16 * kFrame : pass_ms_.back();
    return static_cast<uint32_t>(std::clamp(std::ceil(std::sqrt(sample / kFrame)), 1.0, 8.0));
  }

  void begin_shading_again(const std::string& reason, const Change& change) {
    start_ = Clock::now();
    owes_picture_ = true;
    goal_.forget_picture();
    shown_.set_restarted(renderer_.replayed_pixels());
    if (change.places_moved) forget_ids();
    const std::lock_guard lock(mutex_);
    status_.restart_reason = reason;
    status_.restarted_pixels = change.reshaded;
    status_.samples = 0;
    status_.finished = false;
  }

  void shade_again() {
    const uint64_t value = renderer_.replay(kReplaySamples);
    device_.wait(value);
    if (!renderer_.replay_pass_complete()) return;
    owes_picture_ ? answer(value) : show_all(value);
    owes_picture_ = false;
    const uint32_t samples = renderer_.replayed_samples();
    const bool over = !renderer_.replaying();
    finished_ = over && reached();
    // Else the tiles that follow bring them.
    if (finished_ && ids_stale_) update_ids();
    pass_start_ = Clock::now();
    pass_whole_ = cursor_ == 0;
    const std::lock_guard lock(mutex_);
    status_.samples = samples;
    status_.seconds = seconds_since(start_);
    status_.noise = over ? goal_.noise(renderer_) : -1;
    status_.finished = finished_;
  }

  bool reached() const {
    const RenderSettings& settings = renderer_.project().settings;
    return goal_.reached(renderer_, settings.max_samples, settings.noise_goal);
  }

  void refine_tile() {
    const RenderSettings& settings = renderer_.project().settings;
    const auto wants = [&](int tile) {
      return goal_.wants(renderer_, tile, settings.max_samples, settings.noise_goal);
    };
    // Tiles that are good enough are passed over.
    while (cursor_ < renderer_.tile_count() && !wants(cursor_)) {
      ++cursor_;
      pass_whole_ = false;
    }
    uint32_t batch = 0;
    if (cursor_ < renderer_.tile_count()) {
      const uint32_t before = renderer_.samples_of(cursor_);
      // Not before the first picture, and in parts: all of them would keep the tiles waiting for 70 ms.
      if (ids_stale_ && ids_drawn_ == cursor_ && before > 0 && renderer_.has_aov_kernel())
        renderer_.render_aov(ids_drawn_++);
      const uint64_t value = renderer_.refine(cursor_, settings.max_samples);
      device_.wait(value);
      shown_.show_tile(renderer_, cursor_, value);
      batch = renderer_.samples_of(cursor_) - before;
      if (++cursor_ < renderer_.tile_count()) return;
    }
    cursor_ = 0;
    end_pass(batch);
  }

  void end_pass(uint32_t batch) {
    const uint32_t samples = renderer_.samples();
    if (batch > 0 && pass_whole_) {
      pass_ms_.push_back(1e3 * seconds_since(pass_start_) / batch);
      if (pass_ms_.size() > 9) pass_ms_.pop_front();
    }
    if (samples >= SAMPLES_PER_HIT && prepared_ != renderer_.key()) {
      prepared_ = renderer_.key();
      device_.wait(renderer_.prepare_replay());
    }
    goal_.look(renderer_);
    finished_ = reached();
    // Tiles that were passed over had none drawn.
    if (ids_stale_ && (finished_ || !pass_whole_ || ids_drawn_ == renderer_.tile_count())) update_ids();
    std::vector<double> sorted(pass_ms_.begin(), pass_ms_.end());
    std::sort(sorted.begin(), sorted.end());
    {
      const std::lock_guard lock(mutex_);
      status_.width = renderer_.region().width;
      status_.height = renderer_.region().height;
      status_.samples = samples;
      status_.seconds = seconds_since(start_);
      status_.ms_per_sample = sorted.empty() ? 0 : sorted[sorted.size() / 2];
      status_.noise = goal_.noise(renderer_);
      status_.gpu_bytes = device_.bytes_allocated();
      status_.finished = finished_;
      if (status_.ms_per_sample > 0)
        status_.mrays_per_second = renderer_.rays_per_sample(coverage_) / status_.ms_per_sample * 1e-3;
    }
    pass_start_ = Clock::now();
    pass_whole_ = true;
  }

  void forget_ids() {
    ids_stale_ = true;
    ids_drawn_ = 0;
  }

  void update_ids() {
    const bool drawn = ids_drawn_ == renderer_.tile_count();
    coverage_ = shown_.read_ids(renderer_, drawn ? renderer_.last_submitted() : renderer_.render_aov());
    ids_stale_ = false;
  }

  void show_all(uint64_t value) { shown_.show_all(renderer_, value); }

  void answer(uint64_t value) {
    show_all(value);
    std::function<void()> answered;
    {
      const std::lock_guard lock(mutex_);
      answered = answered_;
      if (answered && device_.info().is_cpu) awaits_showing_ = shown_.version();
    }
    if (answered) answered();
  }

  gpu::Device& device_;

  // They outlive the renderer, whose kernels arrive on threads of their own.
  mutable std::mutex mutex_;
  std::condition_variable wake_;
  bool kernels_arrived_ = false;

  // The renderer: used by the render thread, and by readers between two tiles.
  mutable std::mutex renderer_mutex_;
  mutable std::atomic<int> readers_{0};
  mutable Renderer renderer_;
  int cursor_ = 0;
  bool wants_preview_ = false;
  bool owes_picture_ = false;  // of the last edit, all of it
  bool pass_whole_ = true;     // pass_start_ was at its first tile
  bool ids_stale_ = true;
  int ids_drawn_ = 0;  // tiles of which they are drawn anew, in their order
  std::shared_ptr<const Project> waits_for_kernels_;
  KernelKey prepared_;  // for which replay's kernels are compiled
  double coverage_ = 1;
  Goal goal_;
  std::deque<double> pass_ms_;
  Clock::time_point start_ = Clock::now(), pass_start_ = start_;
  Clock::time_point taken_ = start_;  // when parts moved last

  // What was asked for, and what is told; guarded by mutex_.
  std::shared_ptr<const Project> next_project_;
  std::optional<ivec2> next_size_;
  std::optional<WeightGroup> next_group_;
  WeightGroup asked_group_;
  std::string next_reason_;
  bool paused_ = false, stop_ = false, lose_device_ = false;
  std::atomic<bool> finished_{false}, refused_{false};
  std::atomic<bool> busy_{false};  // something is due even while refinement rests
  RenderStatus status_;
  std::function<void()> answered_;
  uint64_t awaits_showing_ = 0;  // the version that a window is about to show; 0: none

  ShownPicture shown_;

  std::thread thread_;
};

RenderSession::RenderSession(gpu::Device& device, std::shared_ptr<const Project> project, int width, int height,
                             uint64_t edit_memory, Kernels kernels)
    : impl_(std::make_unique<Impl>(device, std::move(project), width, height, edit_memory, kernels)) {}
RenderSession::~RenderSession() = default;

void RenderSession::set_project(std::shared_ptr<const Project> project, std::string reason) {
  impl_->set_project(std::move(project), std::move(reason));
}
void RenderSession::resize(int width, int height) { impl_->resize(width, height); }
void RenderSession::pause(bool paused) { impl_->pause(paused); }
void RenderSession::when_answered(std::function<void()> answered) { impl_->when_answered(std::move(answered)); }
void RenderSession::picture_shown(uint64_t version) { impl_->picture_shown(version); }
void RenderSession::lose_device() { impl_->lose_device(); }
RenderStatus RenderSession::status() const { return impl_->status(); }
void RenderSession::set_weights_at_hand(const WeightGroup& group) { impl_->set_weights_at_hand(group); }
uint64_t RenderSession::picture_version() const { return impl_->shown().version(); }
bool RenderSession::copy_picture(PixelLayer& layer) const { return impl_->shown().copy_picture(layer); }
bool RenderSession::copy_ids(PixelLayer& layer) const { return impl_->shown().copy_ids(layer); }
bool RenderSession::copy_restarted(PixelLayer& layer) const { return impl_->shown().copy_restarted(layer); }
Pick RenderSession::pick(float x, float y) const { return pick_in(impl_->shown().drawn(), x, y); }
std::vector<float> RenderSession::linear_picture(int& width, int& height, uint32_t& samples) const {
  return impl_->linear_picture(width, height, samples);
}

}  // namespace vamp
