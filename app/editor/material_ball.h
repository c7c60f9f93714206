#pragma once
// A small picture of a material on a ball, for the preset library.
#include <cstddef>
#include <vector>

#include "engine/core/error.h"
#include "engine/material/preset.h"

namespace vamp {

class Progress;
namespace gpu {
class Device;
}

// PNG, 256 x 256, on a grey ground as the shipped presets. Renders on a queue of its own; takes a second or two.
Result<std::vector<std::byte>> render_material_ball(gpu::Device& device, const Preset& preset, Progress& progress);

}  // namespace vamp
