#pragma once
// What handles own: shared with the command lists that use it, so that nothing goes while the device still needs it.
#include <vulkan/vulkan.h>

#include <atomic>
#include <memory>
#include <string>
#include <vector>

#include "engine/gpu/buffer.h"

namespace vamp::gpu {

class Device;

struct Resource {
  explicit Resource(Device& owner);
  virtual ~Resource();
  Resource(const Resource&) = delete;
  Resource& operator=(const Resource&) = delete;
  // A command list that uses this was submitted as timeline value `value`.
  virtual void mark_used(uint64_t value) = 0;

  Device& device;
};

struct BufferState final : Resource {
  using Resource::Resource;
  ~BufferState() override;
  void mark_used(uint64_t value) override { last_use.store(value, std::memory_order_release); }

  BufferDesc desc;
  VkBuffer buffer = VK_NULL_HANDLE;
  VkDeviceMemory memory = VK_NULL_HANDLE;
  uint64_t bytes = 0;  // of the buffer, at least those that were asked for
  uint64_t allocated = 0;
  std::byte* mapped = nullptr;
  bool host_cached = false;
  std::atomic<uint64_t> last_use = 0;
  uint32_t staged_copies = 0;  // waiting for the next submit; guarded by the uploader
};

struct ViewState final : Resource {
  using Resource::Resource;
  ~ViewState() override;
  void mark_used(uint64_t value) override { buffer->mark_used(value); }

  std::shared_ptr<BufferState> buffer;
  VkBufferView view = VK_NULL_HANDLE;
  VkFormat format = VK_FORMAT_UNDEFINED;
  uint64_t texels = 0;
};

}  // namespace vamp::gpu
