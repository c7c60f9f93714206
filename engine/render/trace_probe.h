#pragma once
// How long a small picture's rays take in two ways.
#include "engine/render/kernel_key.h"
#include "engine/render/trace_record.h"

namespace vamp {

namespace gpu {
class Device;
}

// Medians of alternating rounds: primary rays and four ambient rays of each, the kernels compiled before. Throws
// MachineError.
Timings time_traces(gpu::Device& device, const TracePath& first, const TracePath& second);

}  // namespace vamp
