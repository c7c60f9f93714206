#pragma once
// What the parts of a material cost in a picture, as ratios within one run: robust forms against textbook forms, the
// kernel for all seven models against kernels for three, each number of terms of the residual against none.
#include "bench/report.h"
#include "engine/project/project.h"

namespace vamp {

namespace gpu {
class Device;
}

struct ShadingBench {
  std::string scene_words;
  int rounds = 9;
  int side = 512;  // pixels
};

// Puts bench_material() on every part; keeps one light. Errors: no light. Throws MachineError.
Result<Report> bench_shading(gpu::Device& device, Project project, const ShadingBench& options);

}  // namespace vamp
