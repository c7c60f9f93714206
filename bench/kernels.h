#pragma once
// How long the picture stands still when kernels are needed that are not there: at the start, for a preset with other
// models, for one more light, at the first edit. In the window's own session, with kernels made beside the queue and on
// it, each with the driver's disk cache empty and full.
#include "bench/report.h"
#include "engine/gpu/device_info.h"
#include "engine/project/project.h"

namespace vamp {

struct KernelsBench {
  std::string scene_words;
  int rounds = 3;
  double seconds = 3;  // that are watched after each event
};

// `plain` is opened; then "Vamp", or else its first part, is given the material that the same part has in `dressed`, of
// the same scene. Every case gets a device of its own, made with these options. Throws MachineError.
Result<Report> bench_kernels(const gpu::Options& device, const Project& plain, const Project& dressed,
                             const KernelsBench& options);

}  // namespace vamp
