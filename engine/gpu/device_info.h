#pragma once
// Which Vulkan devices there are, what they can do and which one is taken.
#include <vulkan/vulkan.h>

#include <cstdint>
#include <string>
#include <vector>

#include "engine/core/error.h"

namespace vamp::gpu {

enum class DeviceType { discrete, integrated, virtual_gpu, cpu, other };

// "discrete", "integrated", "virtual", "cpu", "other".
const char* name_of(DeviceType type);

struct DeviceInfo {
  uint32_t index = 0;      // in list_devices(): what --device takes
  std::string name;        // "llvmpipe (LLVM 15.0.6, 256 bits)"
  std::string driver;      // "llvmpipe Mesa 22.3.6 (LLVM 15.0.6)"
  std::string vendor;      // "NVIDIA", "AMD", "Intel", "Mesa", ... or the number in hexadecimal
  std::string unsuitable;  // why it cannot serve; empty: it can
  DeviceType type = DeviceType::other;
  bool is_cpu = false;
  bool is_lavapipe = false;
  uint32_t vendor_id = 0;
  uint32_t device_id = 0;
  uint32_t api_version = 0;  // as VK_MAKE_API_VERSION
  // The driver's own version, such as 22, 3 of Mesa 22.3.6: how kernels trace is chosen by it.
  uint32_t driver_major = 0;
  uint32_t driver_minor = 0;

  uint32_t subgroup_size = 0;
  uint64_t memory_bytes = 0;              // of the largest device-local heap
  uint64_t max_allocation_bytes = 0;      // of one buffer's memory
  uint64_t max_storage_range = 0;         // bytes of one storage-buffer binding
  uint64_t max_texel_elements = 0;        // texels of one texel-buffer view
  uint64_t storage_offset_alignment = 1;  // bytes
  uint64_t texel_offset_alignment = 1;    // bytes
  uint32_t max_push_bytes = 0;
  uint32_t max_shared_bytes = 0;
  uint32_t max_group_invocations = 0;
  uint32_t max_group_count[3] = {};
  double timestamp_ns = 0;  // length of one timestamp tick; 0: no timestamps

  // Optional features; enabled where present.
  bool float16 = false;        // arithmetic in half floats
  bool int64 = false;          // 64-bit integers
  bool float64 = false;        // double precision
  bool storage_16bit = false;  // 16-bit members in storage buffers
  bool storage_8bit = false;   // 8-bit members in storage buffers
  bool ray_queries = false;    // GL_EXT_ray_query, see acceleration_structure.h
};

// How a device is made.
struct Options {
  // Empty takes the best: a discrete GPU, then an integrated or virtual one, then the CPU. Otherwise an index of
  // list_devices() or a part of a name, upper and lower case alike.
  std::string device;
  // The Khronos validation layer; its messages go to the log and to Device::validation_messages().
  bool validate = false;
  // With validate: missing barriers are found too. Off where dispatches without a barrier between them write disjoint
  // parts of one buffer, which that check cannot tell apart.
  bool validate_synchronization = false;
  // What a window needs on top, such as VK_KHR_surface and VK_KHR_swapchain.
  std::vector<std::string> instance_extensions;
  std::vector<std::string> device_extensions;
};

// All devices, the best first, those that cannot serve last. Error: no_device when there is no Vulkan driver at all.
Result<std::vector<DeviceInfo>> list_devices();

}  // namespace vamp::gpu
