#include "engine/gpu/machine.h"

#include <fmt/format.h>

#include "engine/core/error.h"

namespace vamp::gpu {

std::string text_of(VkResult result) {
  switch (result) {
    case VK_ERROR_OUT_OF_HOST_MEMORY:
      return "out of memory";
    case VK_ERROR_OUT_OF_DEVICE_MEMORY:
      return "out of GPU memory";
    case VK_ERROR_DEVICE_LOST:
      return "the GPU stopped responding (device lost)";
    case VK_ERROR_INITIALIZATION_FAILED:
      return "the driver could not start";
    case VK_ERROR_INCOMPATIBLE_DRIVER:
      return "no Vulkan driver";
    case VK_ERROR_LAYER_NOT_PRESENT:
      return "a layer is not installed";
    case VK_ERROR_EXTENSION_NOT_PRESENT:
      return "an extension is not supported";
    case VK_ERROR_FEATURE_NOT_PRESENT:
      return "a feature is not supported";
    case VK_ERROR_TOO_MANY_OBJECTS:
      return "too many GPU objects";
    case VK_ERROR_INVALID_SHADER_NV:
      return "the driver refused the kernel";
    default:
      return fmt::format("Vulkan error {}", static_cast<int>(result));
  }
}

void require(VkResult result, const std::string& what) {
  if (result >= 0) return;
  throw MachineError(ErrorKind::device_lost, what + ": " + text_of(result));
}

std::string mebibytes(uint64_t bytes) { return fmt::format("{:.1f} MiB", static_cast<double>(bytes) / (1 << 20)); }

}  // namespace vamp::gpu
