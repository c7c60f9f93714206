#pragma once
// Whether directions drawn from a material's own functions help: multiple importance sampling (Veach & Guibas 1995) of
// lights with each texel's mixture, and with the part's sharp highlight, which is the renderer's way
// (shaders/lib/mixture.glsl), against points on lights alone. Without occlusion, on the CPU, so that nothing but the
// choice of directions differs.
#include "bench/report.h"

namespace vamp {

struct MixtureBench {
  int side = 24;         // texels and viewers, a side
  uint32_t rays = 2048;  // of each estimate
};

// Errors: a shipped preset that cannot be read.
Result<Report> bench_mixture(const MixtureBench& options);

}  // namespace vamp
