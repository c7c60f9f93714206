#pragma once
// Whether what the program says of a picture's noise is the error that the picture has.
#include <string>
#include <vector>

#include "bench/report.h"
#include "engine/project/project.h"

namespace vamp {

namespace gpu {
class Device;
}

struct NoiseScene {
  std::string words;
  Project project;
};

struct NoiseBench {
  int width = 160, height = 120;  // pixels
  int rounds = 3;                 // pictures of different random numbers
  uint32_t reference = 4096;      // samples, of yet other ones
};

// At 16, 64 and 256 samples. Throws MachineError.
Result<Report> bench_noise(gpu::Device& device, const std::vector<NoiseScene>& scenes, const NoiseBench& options);

}  // namespace vamp
