#pragma once
// What an acceleration structure owns.
#include <vulkan/vulkan.h>

#include <memory>

#include "engine/gpu/resource.h"

namespace vamp::gpu {

struct AccelerationState final : Resource {
  explicit AccelerationState(Device& owner);
  ~AccelerationState() override;
  void mark_used(uint64_t value) override;

  // Rays meet the top level, whose one instance is the bottom level: the triangles as they are.
  struct Level {
    Buffer memory;
    VkAccelerationStructureKHR handle = VK_NULL_HANDLE;
    uint64_t scratch_bytes = 0;
  };
  uint32_t triangles = 0;
  std::shared_ptr<BufferState> corners;
  Buffer instance;
  Level bottom, top;

  // Extensions have no symbols of their own in the loader.
  struct Calls {
    explicit Calls(VkDevice device);
    PFN_vkCreateAccelerationStructureKHR create;
    PFN_vkDestroyAccelerationStructureKHR destroy;
    PFN_vkGetAccelerationStructureBuildSizesKHR sizes;
    PFN_vkGetAccelerationStructureDeviceAddressKHR address;
    PFN_vkCmdBuildAccelerationStructuresKHR build;
  };
  const Calls calls;
};

}  // namespace vamp::gpu
