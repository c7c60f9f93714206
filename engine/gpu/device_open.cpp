#include "engine/gpu/device_open.h"

#include <algorithm>
#include <bit>
#include <string>
#include <vector>

#include "engine/core/check.h"
#include "engine/gpu/acceleration_structure.h"
#include "engine/gpu/machine.h"

namespace vamp::gpu {

Result<VkDevice> open_device(VkPhysicalDevice physical, uint32_t family, const Options& options) {
  VkPhysicalDeviceProperties properties;
  vkGetPhysicalDeviceProperties(physical, &properties);
  uint32_t count = 0;
  vkEnumerateDeviceExtensionProperties(physical, nullptr, &count, nullptr);
  std::vector<VkExtensionProperties> present(count);
  vkEnumerateDeviceExtensionProperties(physical, nullptr, &count, present.data());
  std::vector<const char*> extensions;
  for (const std::string& name : options.device_extensions) {
    if (std::none_of(present.begin(), present.end(), [&](const auto& e) { return name == e.extensionName; }))
      return fail(ErrorKind::failed, "", properties.deviceName, "the device extension " + name, "a driver without it");
    extensions.push_back(name.c_str());
  }

  RayQueryFeatures rays;
  const bool ray_queries = has_ray_queries(physical);
  if (ray_queries) extensions.insert(extensions.end(), rays.extensions.begin(), rays.extensions.end());

  VkPhysicalDeviceVulkan12Features has12{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES};
  VkPhysicalDeviceVulkan11Features has11{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_1_FEATURES, &has12};
  VkPhysicalDeviceFeatures2 has{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, &has11};
  vkGetPhysicalDeviceFeatures2(physical, &has);
  VkPhysicalDeviceVulkan12Features use12{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES};
  use12.pNext = ray_queries ? &rays.structures : nullptr;
  use12.bufferDeviceAddress = ray_queries;
  use12.timelineSemaphore = VK_TRUE;
  use12.scalarBlockLayout = VK_TRUE;
  use12.shaderFloat16 = has12.shaderFloat16;
  use12.shaderInt8 = has12.shaderInt8;
  use12.storageBuffer8BitAccess = has12.storageBuffer8BitAccess;
  VkPhysicalDeviceVulkan11Features use11{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_1_FEATURES, &use12};
  use11.storageBuffer16BitAccess = has11.storageBuffer16BitAccess;
  VkPhysicalDeviceFeatures2 use{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, &use11};
  use.features.shaderInt64 = has.features.shaderInt64;
  use.features.shaderInt16 = has.features.shaderInt16;
  use.features.shaderFloat64 = has.features.shaderFloat64;
  use.features.shaderStorageImageExtendedFormats = has.features.shaderStorageImageExtendedFormats;
  use.features.shaderStorageImageReadWithoutFormat = has.features.shaderStorageImageReadWithoutFormat;
  use.features.shaderStorageImageWriteWithoutFormat = has.features.shaderStorageImageWriteWithoutFormat;

  const float priority = 1.0f;
  const VkDeviceQueueCreateInfo queue{.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO,
                                      .queueFamilyIndex = family,
                                      .queueCount = 1,
                                      .pQueuePriorities = &priority};
  const VkDeviceCreateInfo info{.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO,
                                .pNext = &use,
                                .queueCreateInfoCount = 1,
                                .pQueueCreateInfos = &queue,
                                .enabledExtensionCount = static_cast<uint32_t>(extensions.size()),
                                .ppEnabledExtensionNames = extensions.data()};
  VkDevice device = VK_NULL_HANDLE;
  if (const VkResult result = vkCreateDevice(physical, &info, nullptr, &device); result != VK_SUCCESS)
    return fail(ErrorKind::no_device, "", properties.deviceName, "a working device", text_of(result));
  return device;
}

uint32_t memory_type(const VkPhysicalDeviceMemoryProperties& memory, VkMemoryPropertyFlags needed,
                     VkMemoryPropertyFlags liked) {
  uint32_t best = UINT32_MAX;
  int best_score = 0;
  for (uint32_t i = 0; i < memory.memoryTypeCount; ++i) {
    const VkMemoryPropertyFlags flags = memory.memoryTypes[i].propertyFlags;
    if ((flags & needed) != needed) continue;
    const int score = 8 * std::popcount(flags & liked) - std::popcount(flags & ~(needed | liked));
    if (best == UINT32_MAX || score > best_score) {
      best = i;
      best_score = score;
    }
  }
  CHECK(best != UINT32_MAX);
  return best;
}

}  // namespace vamp::gpu
