#pragma once
// What the device is to do, recorded once and handed to Device::submit.
#include <vulkan/vulkan.h>

#include <cstdint>
#include <memory>
#include <span>
#include <type_traits>
#include <vector>

#include "engine/gpu/buffer.h"
#include "engine/gpu/pipeline.h"

namespace vamp::gpu {

class AccelerationStructure;
class Device;
class Timestamps;
class Uploader;
struct Resource;

// A command pool with its one buffer; recycled by the device.
struct CommandBuffer {
  VkCommandPool pool = VK_NULL_HANDLE;
  VkCommandBuffer buffer = VK_NULL_HANDLE;
};

// Parts of the machine that a barrier may stand between; combine with |.
enum class Stage : uint32_t { compute = 1, transfer = 2, indirect = 4, graphics = 8, all = 15 };
constexpr Stage operator|(Stage a, Stage b) {
  return static_cast<Stage>(static_cast<uint32_t>(a) | static_cast<uint32_t>(b));
}

// Recorded by one thread, submitted once. A list sees everything that lists submitted before it and uploads made before
// its submit have written, and the host sees what it wrote when its timeline value is reached: barriers are needed only
// between commands of the same list. A list that is dropped without submit does nothing.
class CommandList {
 public:
  CommandList() = default;
  CommandList(CommandList&&) noexcept;
  CommandList& operator=(CommandList&&) noexcept;
  ~CommandList();

  void bind(const ComputePipeline& pipeline, const DescriptorSet& set);
  // The push constants of the bound pipeline, all of them.
  template <class T>
  void push(const T& constants) {
    static_assert(std::is_trivially_copyable_v<T> && sizeof(T) <= 128 && sizeof(T) % 4 == 0);
    push_bytes(&constants, sizeof(T));
  }
  void push_bytes(const void* constants, uint32_t bytes);
  // Numbers of workgroups, not of invocations; a zero does nothing.
  void dispatch(uint32_t groups_x, uint32_t groups_y = 1, uint32_t groups_z = 1);
  // Group counts read from three uint32 at `offset` when the command runs.
  void dispatch_indirect(const Buffer& arguments, uint64_t offset = 0);

  void copy(const Buffer& from, uint64_t from_offset, const Buffer& to, uint64_t to_offset, uint64_t bytes);
  // Offset and size in bytes, multiples of 4 (the end of the buffer may be odd).
  void fill(const Buffer& buffer, uint32_t value, uint64_t offset = 0, uint64_t bytes = VK_WHOLE_SIZE);

  // From the corners that stand in its buffer then, for the first time or after they have moved. Seen by what follows.
  void build(const AccelerationStructure& structure);

  // What was written before is seen by what follows; what follows does not overtake.
  void barrier(Stage from = Stage::compute | Stage::transfer,
               Stage to = Stage::compute | Stage::transfer | Stage::indirect);

  // The time at which everything before is done, into slot `slot`.
  void timestamp(Timestamps& timestamps, uint32_t slot);

  // For commands of one's own: the raw buffer, and what it uses and must keep.
  VkCommandBuffer handle() const { return commands_.buffer; }
  void use(const Buffer& buffer);

 private:
  friend class Device;
  friend class Uploader;
  CommandList(Device& device, CommandBuffer commands) : device_(&device), commands_(commands) {}
  void keep(const std::shared_ptr<Resource>& resource);
  void release();

  Device* device_ = nullptr;
  CommandBuffer commands_;
  std::vector<std::shared_ptr<Resource>> kept_;
  const PipelineState* bound_ = nullptr;
};

}  // namespace vamp::gpu
