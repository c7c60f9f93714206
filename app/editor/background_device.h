#pragma once
// A queue for rendering beside the window's.
#include <memory>

#include "engine/core/error.h"

namespace vamp {

namespace gpu {
class Device;
}

// The window's device once more, so that a frame of the window never waits behind a tile. Where Vulkan runs on the CPU
// its threads get a lower priority than the window's, which keeps the window fluent while they use all cores.
Result<std::unique_ptr<gpu::Device>> background_device(const gpu::Device& window_device);

}  // namespace vamp
