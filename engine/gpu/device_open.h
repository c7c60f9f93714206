#pragma once
// How a Vulkan device is made: the features and the queue that the program needs.
#include <vulkan/vulkan.h>

#include "engine/core/error.h"
#include "engine/gpu/device_info.h"

namespace vamp::gpu {

// A logical device with one queue of `family`. Needed: timeline semaphores, scalar block layout. Enabled where present:
// half floats, 16- and 64-bit integers, doubles, small storage members, storage texels without a format, ray queries.
Result<VkDevice> open_device(VkPhysicalDevice physical, uint32_t family, const Options& options);

// The memory type that has all `needed` flags, most of `liked` and as few others as possible. Every driver has a
// host-visible coherent and a device-local type (Vulkan specification, "Device Memory").
uint32_t memory_type(const VkPhysicalDeviceMemoryProperties& memory, VkMemoryPropertyFlags needed,
                     VkMemoryPropertyFlags liked);

}  // namespace vamp::gpu
