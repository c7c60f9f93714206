#pragma once
// Vulkan's return codes as the program's errors.
#include <vulkan/vulkan.h>

#include <string>

namespace vamp::gpu {

// "the device was lost", "out of GPU memory", ... in words a user understands.
std::string text_of(VkResult result);

// Throws MachineError(device_lost) with "what: text" unless the call succeeded.
void require(VkResult result, const std::string& what);

// "12.5 MiB"
std::string mebibytes(uint64_t bytes);

}  // namespace vamp::gpu
