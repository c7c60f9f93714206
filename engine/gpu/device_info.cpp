#include "engine/gpu/device_info.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstring>

#include "engine/gpu/acceleration_structure.h"
#include "engine/gpu/instance.h"

namespace vamp::gpu {
namespace {

DeviceType type_of(VkPhysicalDeviceType type) {
  switch (type) {
    case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU:
      return DeviceType::discrete;
    case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU:
      return DeviceType::integrated;
    case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU:
      return DeviceType::virtual_gpu;
    case VK_PHYSICAL_DEVICE_TYPE_CPU:
      return DeviceType::cpu;
    default:
      return DeviceType::other;
  }
}

std::string vendor_of(uint32_t id) {
  switch (id) {
    case 0x1002:
      return "AMD";
    case 0x10DE:
      return "NVIDIA";
    case 0x8086:
      return "Intel";
    case 0x13B5:
      return "Arm";
    case 0x5143:
      return "Qualcomm";
    case 0x106B:
      return "Apple";
    case VK_VENDOR_ID_MESA:
      return "Mesa";
    default:
      return fmt::format("{:#06x}", id);
  }
}

// Mesa says its version in the driver's text ("Mesa 22.3.6 (LLVM 15.0.6)") whatever the driver; lavapipe's number is
// 0.0.1 in all releases of that time. NVIDIA packs 10 + 8 bits; the others use Vulkan's own packing.
void read_driver_version(const VkPhysicalDeviceProperties& core, const char* driver_info, DeviceInfo& info) {
  if (std::sscanf(driver_info, "Mesa %u.%u", &info.driver_major, &info.driver_minor) == 2) return;
  const bool nvidia = core.vendorID == 0x10DE;
  info.driver_major = nvidia ? core.driverVersion >> 22 : VK_API_VERSION_MAJOR(core.driverVersion);
  info.driver_minor = nvidia ? (core.driverVersion >> 14) & 0xff : VK_API_VERSION_MINOR(core.driverVersion);
}

void read_limits(const VkPhysicalDeviceLimits& limits, DeviceInfo& info) {
  info.max_storage_range = limits.maxStorageBufferRange;
  info.max_texel_elements = limits.maxTexelBufferElements;
  info.storage_offset_alignment = limits.minStorageBufferOffsetAlignment;
  info.texel_offset_alignment = limits.minTexelBufferOffsetAlignment;
  info.max_push_bytes = limits.maxPushConstantsSize;
  info.max_shared_bytes = limits.maxComputeSharedMemorySize;
  info.max_group_invocations = limits.maxComputeWorkGroupInvocations;
  std::copy_n(limits.maxComputeWorkGroupCount, 3, info.max_group_count);
  info.timestamp_ns = limits.timestampComputeAndGraphics ? static_cast<double>(limits.timestampPeriod) : 0.0;
}

std::string missing(VkPhysicalDevice physical, const VkPhysicalDeviceProperties& core,
                    const VkPhysicalDeviceVulkan12Features& features) {
  if (core.apiVersion < VK_API_VERSION_1_2)
    return fmt::format("Vulkan {}.{} (1.2 is needed)", VK_API_VERSION_MAJOR(core.apiVersion),
                       VK_API_VERSION_MINOR(core.apiVersion));
  if (!features.timelineSemaphore) return "no timeline semaphores";
  if (!features.scalarBlockLayout) return "no scalar block layout";
  if (compute_family(physical) == UINT32_MAX) return "no compute queue";
  return {};
}

}  // namespace

const char* name_of(DeviceType type) {
  switch (type) {
    case DeviceType::discrete:
      return "discrete";
    case DeviceType::integrated:
      return "integrated";
    case DeviceType::virtual_gpu:
      return "virtual";
    case DeviceType::cpu:
      return "cpu";
    case DeviceType::other:
      return "other";
  }
  return "other";
}

uint32_t compute_family(VkPhysicalDevice physical) {
  uint32_t count = 0;
  vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, families.data());
  for (const VkQueueFlags wanted : {VK_QUEUE_COMPUTE_BIT | VK_QUEUE_GRAPHICS_BIT, int{VK_QUEUE_COMPUTE_BIT}})
    for (uint32_t i = 0; i < count; ++i)
      if ((families[i].queueFlags & wanted) == wanted) return i;
  return UINT32_MAX;
}

DeviceInfo describe(VkPhysicalDevice physical) {
  VkPhysicalDeviceDriverProperties driver{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_DRIVER_PROPERTIES};
  VkPhysicalDeviceSubgroupProperties subgroup{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_SUBGROUP_PROPERTIES, &driver};
  VkPhysicalDeviceMaintenance3Properties maintenance{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_MAINTENANCE_3_PROPERTIES,
                                                     &subgroup};
  VkPhysicalDeviceProperties2 properties{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2, &maintenance};
  vkGetPhysicalDeviceProperties2(physical, &properties);
  VkPhysicalDeviceVulkan12Features vulkan12{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES};
  VkPhysicalDeviceVulkan11Features vulkan11{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_1_FEATURES, &vulkan12};
  VkPhysicalDeviceFeatures2 features{VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2, &vulkan11};
  vkGetPhysicalDeviceFeatures2(physical, &features);
  VkPhysicalDeviceMemoryProperties memory;
  vkGetPhysicalDeviceMemoryProperties(physical, &memory);

  const auto& core = properties.properties;
  DeviceInfo info;
  info.name = core.deviceName;
  info.driver = driver.driverName;
  if (driver.driverInfo[0]) info.driver += std::string(" ") + driver.driverInfo;
  info.vendor = vendor_of(core.vendorID);
  info.type = type_of(core.deviceType);
  info.is_cpu = info.type == DeviceType::cpu;
  info.is_lavapipe = driver.driverID == VK_DRIVER_ID_MESA_LLVMPIPE;
  info.vendor_id = core.vendorID;
  info.device_id = core.deviceID;
  info.api_version = core.apiVersion;
  read_driver_version(core, driver.driverInfo, info);
  read_limits(core.limits, info);
  info.subgroup_size = subgroup.subgroupSize;
  info.max_allocation_bytes = maintenance.maxMemoryAllocationSize;
  for (uint32_t i = 0; i < memory.memoryHeapCount; ++i)
    if (memory.memoryHeaps[i].flags & VK_MEMORY_HEAP_DEVICE_LOCAL_BIT)
      info.memory_bytes = std::max<uint64_t>(info.memory_bytes, memory.memoryHeaps[i].size);
  info.float16 = vulkan12.shaderFloat16;
  info.int64 = features.features.shaderInt64;
  info.float64 = features.features.shaderFloat64;
  info.storage_16bit = vulkan11.storageBuffer16BitAccess && features.features.shaderInt16;
  info.storage_8bit = vulkan12.storageBuffer8BitAccess && vulkan12.shaderInt8;
  info.ray_queries = has_ray_queries(physical);
  info.unsuitable = missing(physical, core, vulkan12);
  return info;
}

Result<std::vector<DeviceInfo>> list_devices() {
  VAMP_TRY(auto instance, Instance::create({}));
  VAMP_TRY(auto candidates, instance->candidates());
  std::vector<DeviceInfo> all;
  for (auto& candidate : candidates) all.push_back(std::move(candidate.info));
  return all;
}

}  // namespace vamp::gpu
