#pragma once
// Triangles as a device's own ray queries read them (VK_KHR_acceleration_structure): the only place that knows how.
#include <vulkan/vulkan.h>

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engine/gpu/buffer.h"

namespace vamp::gpu {

class Device;
struct AccelerationState;

// Whether kernels can ask the device for rays (GL_EXT_ray_query).
bool has_ray_queries(VkPhysicalDevice physical);

// What a device must be opened with, so that they can. Stays where it is while the device is made.
struct RayQueryFeatures {
  std::vector<const char*> extensions;
  VkPhysicalDeviceAccelerationStructureFeaturesKHR structures{
      VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_ACCELERATION_STRUCTURE_FEATURES_KHR};
  VkPhysicalDeviceRayQueryFeaturesKHR queries{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_RAY_QUERY_FEATURES_KHR};

  RayQueryFeatures();
  RayQueryFeatures(const RayQueryFeatures&) = delete;
  RayQueryFeatures& operator=(const RayQueryFeatures&) = delete;
};

// One list of triangles, both sides of each, none of them taken as opaque. Keeps its corners' memory alive.
class AccelerationStructure {
 public:
  AccelerationStructure() = default;
  // `corners`: of 16 bytes each, x y z and what else there is, three for each of the `triangles`, which keep their
  // numbers; of Usage::ray_input. Nothing is built: see CommandList::build. The device must have ray queries. Throws
  // MachineError when memory runs out.
  AccelerationStructure(Device& device, const std::string& name, const Buffer& corners, uint32_t triangles);

  explicit operator bool() const { return state_ != nullptr; }
  const std::shared_ptr<AccelerationState>& state() const { return state_; }

  AccelerationStructure(AccelerationStructure&&) noexcept = default;
  AccelerationStructure& operator=(AccelerationStructure&&) noexcept = default;

 private:
  std::shared_ptr<AccelerationState> state_;
};

}  // namespace vamp::gpu
