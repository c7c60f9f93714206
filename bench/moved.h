#pragma once
// What a part that is moved costs: making the tree fit against making it anew, and rays in the one and in the other.
#include "bench/report.h"
#include "engine/project/project.h"

namespace vamp {

namespace gpu {
class Device;
}

// Adds a table to the report. Throws MachineError. Errors: a scene too large for the device.
Status measure_moved_parts(gpu::Device& device, const Project& project, int rounds, Report& report);

}  // namespace vamp
