#pragma once
// What each short cut costs in error and saves in time: relMSE and MSSIM against a converged picture, over the time
// that a progressive picture has had.
#include "bench/plot.h"
#include "engine/core/files.h"
#include "engine/project/project.h"

namespace vamp {

namespace gpu {
class Device;
}

struct SpeedErrorBench {
  std::string name = "speed-error";  // of the report
  std::string scene_words;
  fs::path cache;                      // where the reference is kept between runs
  uint32_t reference_samples = 16384;  // of numbers of its own
  int side = 128;                      // pixels
  uint32_t samples = 256;              // of the curves of short cuts
  int rounds = 3;                      // pictures of different seeds, alternating
};

struct SpeedError {
  Report report;
  std::vector<Plot> plots;
};

// Errors: the cache cannot be written. Throws MachineError.
Result<SpeedError> bench_speed_error(gpu::Device& device, const Project& project, const SpeedErrorBench& options);

}  // namespace vamp
