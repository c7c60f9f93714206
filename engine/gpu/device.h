#pragma once
// The Vulkan device: its one queue with its timeline, its memory, uploads and readback. Threads may share it.
#include <vulkan/vulkan.h>

#include <atomic>
#include <chrono>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <span>
#include <string>
#include <vector>

#include "engine/core/error.h"
#include "engine/gpu/buffer.h"
#include "engine/gpu/command_list.h"
#include "engine/gpu/device_info.h"
#include "engine/gpu/pipeline.h"

namespace vamp::gpu {

class Instance;
class Uploader;

// Semaphores of a window's swapchain around a submit.
struct SubmitSync {
  VkSemaphore wait = VK_NULL_HANDLE;
  VkPipelineStageFlags wait_stage = VK_PIPELINE_STAGE_ALL_COMMANDS_BIT;
  VkSemaphore signal = VK_NULL_HANDLE;
};

constexpr std::chrono::nanoseconds kForever = std::chrono::nanoseconds::max();

class Device {
 public:
  // Errors: no_device when no device serves or none is named so; failed when an extension or the validation layer is
  // missing. A device must outlive everything made from it.
  static Result<std::unique_ptr<Device>> create(const Options& options = {});
  // The same physical device once more with a queue of its own, such as for compiling kernels by dummy dispatches
  // without stopping the first queue. Shares the instance and its validation messages.
  Result<std::unique_ptr<Device>> sibling() const;
  ~Device();
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  const DeviceInfo& info() const { return info_; }
  // True where the host sees all of the device's memory (lavapipe, most integrated GPUs).
  bool unified_memory() const { return unified_; }

  // Priority of the thread that opened it, which those of a driver that computes on the processor have inherited.
  int nice() const { return nice_; }

  // --- The queue and its timeline. Every submit gets the next value; values are reached in order.
  CommandList begin(const char* name = nullptr);
  // Hands the list over and returns its timeline value. Staged uploads go first. Throws MachineError.
  uint64_t submit(CommandList&& list, const SubmitSync& sync = {});
  uint64_t last_submitted() const { return submitted_.load(std::memory_order_acquire); }
  // Whether the work of this value is done; does not wait. Throws MachineError when the device was lost.
  bool done(uint64_t value);
  // Waits until it is, at most that long; false when the time ran out first.
  bool wait(uint64_t value, std::chrono::nanoseconds timeout = kForever);
  // Runs `release` once everything submitted so far is done (in a later submit, wait or bytes_allocated).
  void retire(std::function<void()> release);

  // --- Data.
  // Writes bytes into the buffer, ordered after the work submitted so far and before the next submit: at once where
  // the memory is mapped and the buffer idle, else through the staging ring. Returns the bytes.
  uint64_t upload(const Buffer& buffer, uint64_t offset, std::span<const std::byte> bytes);
  template <class T>
  uint64_t upload_rows(const TypedBuffer<T>& buffer, uint64_t first, std::span<const std::type_identity_t<T>> rows) {
    return upload(buffer, first * sizeof(T), std::as_bytes(rows));
  }
  // Waits for the timeline value (and for uploads into the buffer), then reads. Throws MachineError.
  void readback(const Buffer& buffer, uint64_t offset, std::span<std::byte> into, uint64_t after);
  template <class T>
  std::vector<T> readback_rows(const TypedBuffer<T>& buffer, uint64_t first, uint64_t count, uint64_t after) {
    std::vector<T> rows(static_cast<size_t>(count));
    readback(buffer, first * sizeof(T), std::as_writable_bytes(std::span(rows)), after);
    return rows;
  }
  uint64_t bytes_uploaded() const { return uploaded_.load(std::memory_order_relaxed); }
  // What is allocated now, staging included; what is no longer needed is freed first.
  uint64_t bytes_allocated();

  // --- Whether something fits before it is made; the error names `what`, the limit and the size. Kind bad_input, for
  // sizes come from the user's files.
  Status fits_storage_range(const std::string& what, uint64_t bytes) const;
  Status fits_texel_view(const std::string& what, uint64_t texels) const;

  // --- Validation. Warnings and errors so far (at most the first 1,000 are kept); all of the instance, siblings too.
  std::vector<std::string> validation_messages() const;
  uint64_t validation_count() const;
  bool validating() const;

  // --- For Vulkan code of one's own (the window).
  VkInstance instance() const;
  VkPhysicalDevice physical() const { return physical_; }
  VkDevice handle() const { return device_; }
  VkQueue queue() const { return queue_; }
  uint32_t family() const { return family_; }
  // Held around direct use of the queue, such as vkQueuePresentKHR.
  std::mutex& queue_mutex() { return queue_mutex_; }
  // Names an object for the validation layer; nothing without it.
  void name_object(VkObjectType type, uint64_t handle, const std::string& name) const;

 private:
  friend class Buffer;
  friend class CommandList;
  friend class Uploader;
  friend class DescriptorSet;
  friend class ComputePipeline;
  friend struct Resource;
  friend struct BufferState;

  struct InFlight {
    uint64_t value = 0;
    std::vector<CommandBuffer> commands;
    std::vector<std::shared_ptr<Resource>> kept;
    std::function<void()> release;
  };

  Device() = default;
  static Result<std::unique_ptr<Device>> create(std::shared_ptr<Instance> instance, const Options& options);
  Status open();
  void choose_memory();
  CommandBuffer take_commands();
  void recycle(CommandBuffer commands);
  uint64_t completed();
  void collect();
  std::shared_ptr<SetLayout> set_layout(std::vector<Binding> bindings);

  std::shared_ptr<Instance> instance_;
  Options options_;
  DeviceInfo info_;
  VkPhysicalDevice physical_ = VK_NULL_HANDLE;
  VkDevice device_ = VK_NULL_HANDLE;
  VkQueue queue_ = VK_NULL_HANDLE;
  uint32_t family_ = 0;
  bool unified_ = false;
  int nice_ = 0;
  uint32_t memory_type_[3] = {};  // by Memory
  VkMemoryPropertyFlags memory_flags_[3] = {};

  std::mutex queue_mutex_;
  VkSemaphore timeline_ = VK_NULL_HANDLE;
  std::atomic<uint64_t> submitted_ = 0;
  std::atomic<uint64_t> completed_ = 0;

  std::mutex lists_mutex_;
  std::deque<InFlight> in_flight_;
  std::vector<CommandBuffer> free_commands_;

  std::mutex layouts_mutex_;
  std::map<std::vector<Binding>, std::shared_ptr<SetLayout>> layouts_;

  std::unique_ptr<Uploader> uploader_;
  std::atomic<uint64_t> allocated_ = 0;
  std::atomic<uint64_t> uploaded_ = 0;
  std::atomic<uint64_t> resources_ = 0;  // alive
};

}  // namespace vamp::gpu
