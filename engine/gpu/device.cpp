#include "engine/gpu/device.h"

#include <fmt/format.h>
#include <sys/resource.h>

#include <algorithm>
#include <charconv>
#include <cstring>
#include <utility>

#include "engine/core/check.h"
#include "engine/core/text.h"
#include "engine/gpu/device_open.h"
#include "engine/gpu/instance.h"
#include "engine/gpu/machine.h"
#include "engine/gpu/pipeline_state.h"
#include "engine/gpu/resource.h"
#include "engine/gpu/uploader.h"

namespace vamp::gpu {
namespace {

// The device that `wanted` means: an index, a part of a name, or empty for the best that serves.
Result<Instance::Candidate> choose(std::vector<Instance::Candidate> all, const std::string& wanted) {
  std::string names;
  for (const auto& [physical, info] : all)
    names += fmt::format("{}{}: {}", names.empty() ? "" : ", ", info.index, info.name);
  uint32_t index = UINT32_MAX;
  const auto [end, error] = std::from_chars(wanted.data(), wanted.data() + wanted.size(), index);
  const bool is_index = !wanted.empty() && error == std::errc() && end == wanted.data() + wanted.size();
  const auto found = std::find_if(all.begin(), all.end(), [&](const Instance::Candidate& candidate) {
    if (wanted.empty()) return candidate.info.unsuitable.empty();
    if (is_index) return candidate.info.index == index;
    return lower(candidate.info.name).find(lower(wanted)) != std::string::npos;
  });
  if (found == all.end()) {
    if (wanted.empty())
      return fail(ErrorKind::no_device, "", "Vulkan",
                  "a device with Vulkan 1.2, timeline semaphores and scalar block layout", names);
    return fail(ErrorKind::no_device, "", "device '" + wanted + "'", "one of " + names, "no such device");
  }
  if (!found->info.unsuitable.empty())
    return fail(ErrorKind::no_device, "", found->info.name, "Vulkan 1.2, timeline semaphores and scalar block layout",
                found->info.unsuitable);
  return *found;
}

void memory_barrier(VkCommandBuffer commands, VkPipelineStageFlags to_stage, VkAccessFlags to_access) {
  const VkMemoryBarrier barrier{.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER,
                                .srcAccessMask = VK_ACCESS_MEMORY_WRITE_BIT,
                                .dstAccessMask = to_access};
  vkCmdPipelineBarrier(commands, VK_PIPELINE_STAGE_ALL_COMMANDS_BIT, to_stage, 0, 1, &barrier, 0, nullptr, 0, nullptr);
}

}  // namespace

Result<std::unique_ptr<Device>> Device::create(const Options& options) {
  VAMP_TRY(auto instance, Instance::create(options));
  return create(std::move(instance), options);
}

Result<std::unique_ptr<Device>> Device::sibling() const {
  Options options = options_;
  options.device = std::to_string(info_.index);
  return create(instance_, options);
}

Result<std::unique_ptr<Device>> Device::create(std::shared_ptr<Instance> instance, const Options& options) {
  auto device = std::unique_ptr<Device>(new Device);
  device->instance_ = std::move(instance);
  device->options_ = options;
  VAMP_CHECK_STATUS(device->open());
  return device;
}

Status Device::open() {
  VAMP_TRY(auto candidates, instance_->candidates());
  VAMP_TRY(auto chosen, choose(std::move(candidates), options_.device));
  physical_ = chosen.physical;
  info_ = std::move(chosen.info);
  family_ = compute_family(physical_);
  nice_ = getpriority(PRIO_PROCESS, 0);
  VAMP_TRY(device_, open_device(physical_, family_, options_));
  vkGetDeviceQueue(device_, family_, 0, &queue_);
  choose_memory();

  const VkSemaphoreTypeCreateInfo type{.sType = VK_STRUCTURE_TYPE_SEMAPHORE_TYPE_CREATE_INFO,
                                       .semaphoreType = VK_SEMAPHORE_TYPE_TIMELINE};
  const VkSemaphoreCreateInfo semaphore{.sType = VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO, .pNext = &type};
  if (const VkResult result = vkCreateSemaphore(device_, &semaphore, nullptr, &timeline_); result != VK_SUCCESS)
    return fail(ErrorKind::no_device, "", info_.name, "a timeline semaphore", text_of(result));
  name_object(VK_OBJECT_TYPE_SEMAPHORE, reinterpret_cast<uint64_t>(timeline_), "timeline");
  uploader_ = std::make_unique<Uploader>(*this);
  return {};
}

void Device::choose_memory() {
  VkPhysicalDeviceMemoryProperties memory;
  vkGetPhysicalDeviceMemoryProperties(physical_, &memory);
  constexpr VkMemoryPropertyFlags local = VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT;
  constexpr VkMemoryPropertyFlags host = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
  constexpr VkMemoryPropertyFlags cached = VK_MEMORY_PROPERTY_HOST_CACHED_BIT;
  const auto exists = [&](VkMemoryPropertyFlags flags) {
    return std::any_of(memory.memoryTypes, memory.memoryTypes + memory.memoryTypeCount,
                       [flags](const VkMemoryType& type) { return (type.propertyFlags & flags) == flags; });
  };
  // A discrete GPU may show the host a window of its memory; the rest of it would still need staging.
  unified_ = (info_.is_cpu || info_.type == DeviceType::integrated) && exists(local | host);
  memory_type_[0] = memory_type(memory, unified_ ? local | host : local, unified_ ? cached : 0);
  memory_type_[1] = memory_type(memory, host, 0);
  memory_type_[2] = memory_type(memory, exists(host | cached) ? host | cached : host, 0);
  for (int i = 0; i < 3; ++i) {
    memory_flags_[i] = memory.memoryTypes[memory_type_[i]].propertyFlags;
    // Memory that the host sees without coherence is not mapped: nobody flushes it.
    if ((memory_flags_[i] & host) != host) memory_flags_[i] &= ~(host | cached);
  }
}

Device::~Device() {
  if (!device_) return;
  vkDeviceWaitIdle(device_);
  completed_ = UINT64_MAX;  // also when the device was lost: nothing runs any more
  collect();
  uploader_.reset();
  CHECK(resources_ == 0);
  for (const CommandBuffer& commands : free_commands_) vkDestroyCommandPool(device_, commands.pool, nullptr);
  for (const auto& [bindings, layout] : layouts_) vkDestroyDescriptorSetLayout(device_, layout->layout, nullptr);
  vkDestroySemaphore(device_, timeline_, nullptr);
  vkDestroyDevice(device_, nullptr);
}

CommandBuffer Device::take_commands() {
  CommandBuffer taken;
  {
    const std::scoped_lock lock(lists_mutex_);
    if (!free_commands_.empty()) {
      taken = free_commands_.back();
      free_commands_.pop_back();
    }
  }
  if (taken.pool) {
    require(vkResetCommandPool(device_, taken.pool, 0), "GPU commands");
    return taken;
  }
  const VkCommandPoolCreateInfo pool{.sType = VK_STRUCTURE_TYPE_COMMAND_POOL_CREATE_INFO,
                                     .flags = VK_COMMAND_POOL_CREATE_TRANSIENT_BIT,
                                     .queueFamilyIndex = family_};
  require(vkCreateCommandPool(device_, &pool, nullptr, &taken.pool), "GPU commands");
  const VkCommandBufferAllocateInfo allocate{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_ALLOCATE_INFO,
                                             .commandPool = taken.pool,
                                             .level = VK_COMMAND_BUFFER_LEVEL_PRIMARY,
                                             .commandBufferCount = 1};
  require(vkAllocateCommandBuffers(device_, &allocate, &taken.buffer), "GPU commands");
  return taken;
}

void Device::recycle(CommandBuffer commands) {
  const std::scoped_lock lock(lists_mutex_);
  free_commands_.push_back(commands);
}

CommandList Device::begin(const char* name) {
  CommandList list(*this, take_commands());
  const VkCommandBufferBeginInfo info{.sType = VK_STRUCTURE_TYPE_COMMAND_BUFFER_BEGIN_INFO,
                                      .flags = VK_COMMAND_BUFFER_USAGE_ONE_TIME_SUBMIT_BIT};
  require(vkBeginCommandBuffer(list.handle(), &info), "GPU commands");
  if (name) name_object(VK_OBJECT_TYPE_COMMAND_BUFFER, reinterpret_cast<uint64_t>(list.handle()), name);
  // Everything earlier on the queue is done and seen.
  memory_barrier(list.handle(), VK_PIPELINE_STAGE_ALL_COMMANDS_BIT,
                 VK_ACCESS_MEMORY_READ_BIT | VK_ACCESS_MEMORY_WRITE_BIT);
  return list;
}

uint64_t Device::submit(CommandList&& list, const SubmitSync& sync) {
  CommandList taken = std::move(list);
  CHECK(taken.device_ == this);
  collect();
  const auto end = [](const CommandList& ended) {
    // What was written is seen by a host that waited for the timeline.
    memory_barrier(ended.handle(), VK_PIPELINE_STAGE_HOST_BIT, VK_ACCESS_HOST_READ_BIT);
    require(vkEndCommandBuffer(ended.handle()), "GPU commands");
  };
  end(taken);

  const std::scoped_lock lock(queue_mutex_);
  const uint64_t value = submitted_ + 1;
  CommandList uploads;
  if (uploader_->any()) {
    uploads = begin("staged uploads");
    uploader_->record(uploads, value);
    end(uploads);
  }
  const VkCommandBuffer commands[] = {uploads.handle() ? uploads.handle() : taken.handle(), taken.handle()};
  const VkSemaphore signals[] = {timeline_, sync.signal};
  const uint64_t signal_values[] = {value, 0}, wait_values[] = {0};
  const VkTimelineSemaphoreSubmitInfo timeline{.sType = VK_STRUCTURE_TYPE_TIMELINE_SEMAPHORE_SUBMIT_INFO,
                                               .waitSemaphoreValueCount = sync.wait ? 1u : 0u,
                                               .pWaitSemaphoreValues = wait_values,
                                               .signalSemaphoreValueCount = sync.signal ? 2u : 1u,
                                               .pSignalSemaphoreValues = signal_values};
  const VkSubmitInfo info{.sType = VK_STRUCTURE_TYPE_SUBMIT_INFO,
                          .pNext = &timeline,
                          .waitSemaphoreCount = sync.wait ? 1u : 0u,
                          .pWaitSemaphores = &sync.wait,
                          .pWaitDstStageMask = &sync.wait_stage,
                          .commandBufferCount = uploads.handle() ? 2u : 1u,
                          .pCommandBuffers = commands,
                          .signalSemaphoreCount = sync.signal ? 2u : 1u,
                          .pSignalSemaphores = signals};
  for (const CommandList* sent : {&uploads, &taken})
    for (const auto& resource : sent->kept_) resource->mark_used(value);
  require(vkQueueSubmit(queue_, 1, &info, VK_NULL_HANDLE), "GPU work");
  submitted_.store(value, std::memory_order_release);

  InFlight flight{.value = value, .commands = {}, .kept = std::move(taken.kept_), .release = {}};
  flight.kept.insert(flight.kept.end(), uploads.kept_.begin(), uploads.kept_.end());
  for (CommandList* sent : {&uploads, &taken})
    if (sent->handle()) flight.commands.push_back(std::exchange(sent->commands_, {}));
  const std::scoped_lock lists(lists_mutex_);
  in_flight_.push_back(std::move(flight));
  return value;
}

uint64_t Device::completed() {
  if (completed_.load(std::memory_order_acquire) == UINT64_MAX) return UINT64_MAX;
  uint64_t now = 0;
  require(vkGetSemaphoreCounterValue(device_, timeline_, &now), "GPU work");
  uint64_t before = completed_.load(std::memory_order_relaxed);
  while (before < now && !completed_.compare_exchange_weak(before, now, std::memory_order_acq_rel)) {
  }
  return std::max(before, now);
}

bool Device::done(uint64_t value) {
  return value <= completed_.load(std::memory_order_acquire) || value <= completed();
}

bool Device::wait(uint64_t value, std::chrono::nanoseconds timeout) {
  CHECK(value <= last_submitted());
  if (!done(value)) {
    const VkSemaphoreWaitInfo info{.sType = VK_STRUCTURE_TYPE_SEMAPHORE_WAIT_INFO,
                                   .semaphoreCount = 1,
                                   .pSemaphores = &timeline_,
                                   .pValues = &value};
    const uint64_t limit =
        timeout == kForever ? UINT64_MAX : static_cast<uint64_t>(std::max<int64_t>(0, timeout.count()));
    const VkResult result = vkWaitSemaphores(device_, &info, limit);
    if (result == VK_TIMEOUT) return false;
    require(result, "GPU work");
  }
  collect();
  return true;
}

void Device::collect() {
  const uint64_t now = completed();
  std::vector<InFlight> finished;
  {
    const std::scoped_lock lock(lists_mutex_);
    for (; !in_flight_.empty() && in_flight_.front().value <= now; in_flight_.pop_front())
      finished.push_back(std::move(in_flight_.front()));
  }
  // Outside the lock: releasing may call back.
  for (InFlight& flight : finished) {
    for (const CommandBuffer& commands : flight.commands) recycle(commands);
    if (flight.release) flight.release();
  }
}

void Device::retire(std::function<void()> release) {
  const std::scoped_lock lock(lists_mutex_);
  in_flight_.push_back({.value = last_submitted(), .commands = {}, .kept = {}, .release = std::move(release)});
}

uint64_t Device::upload(const Buffer& buffer, uint64_t offset, std::span<const std::byte> bytes) {
  CHECK(buffer && offset <= buffer.bytes() && bytes.size() <= buffer.bytes() - offset);
  if (bytes.empty()) return 0;
  uploader_->upload(buffer.state(), offset, bytes);
  uploaded_.fetch_add(bytes.size(), std::memory_order_relaxed);
  return bytes.size();
}

void Device::readback(const Buffer& buffer, uint64_t offset, std::span<std::byte> into, uint64_t after) {
  CHECK(buffer && offset <= buffer.bytes() && into.size() <= buffer.bytes() - offset);
  if (into.empty()) return;
  if (uploader_->waiting(*buffer.state())) after = std::max(after, submit(begin("staged uploads")));
  const auto& state = *buffer.state();
  if (state.mapped && state.host_cached) {
    wait(after);
    std::memcpy(into.data(), state.mapped + offset, into.size());
    return;
  }
  // Reading memory that is not cached is a hundred times slower than letting the device copy it.
  const Buffer copy(*this, {"readback", into.size(), Usage::none, Memory::readback});
  CommandList list = begin("readback");
  list.copy(buffer, offset, copy, 0, into.size());
  wait(std::max(after, submit(std::move(list))));
  std::memcpy(into.data(), copy.mapped(), into.size());
}

uint64_t Device::bytes_allocated() {
  collect();
  return allocated_.load(std::memory_order_relaxed);
}

Status Device::fits_storage_range(const std::string& what, uint64_t bytes) const {
  if (bytes <= info_.max_storage_range) return {};
  return fail(ErrorKind::bad_input, "", what,
              fmt::format("at most {} in one storage buffer of {}", mebibytes(info_.max_storage_range), info_.name),
              mebibytes(bytes));
}

Status Device::fits_texel_view(const std::string& what, uint64_t texels) const {
  if (texels <= info_.max_texel_elements) return {};
  return fail(ErrorKind::bad_input, "", what,
              fmt::format("at most {} texels in one view of {}", info_.max_texel_elements, info_.name),
              fmt::format("{}", texels));
}

VkInstance Device::instance() const { return instance_->handle(); }
bool Device::validating() const { return instance_->validating(); }
std::vector<std::string> Device::validation_messages() const { return instance_->messages(); }
uint64_t Device::validation_count() const { return instance_->message_count(); }
void Device::name_object(VkObjectType type, uint64_t handle, const std::string& name) const {
  instance_->name_object(device_, type, handle, name);
}

}  // namespace vamp::gpu
