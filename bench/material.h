#pragma once
// A made-up material with as much in it as a fitted one, for measurements of costs.
#include <cstdint>
#include <span>

#include "engine/material/spmm.h"
#include "engine/project/project.h"

namespace vamp {

struct BenchMaterial {
  std::vector<Model> used;       // models that texels refer to, in their usual variants
  std::vector<Model> also_held;  // models that stand in the dictionary without being referred to
  int functions = 6;             // of each texel
  bool residual = true;          // mean and four terms over the 81 directions of UBO2003
  uint32_t seed = 1;             // of all that is random
};

// 256 x 256 texels in cells of 8 x 8 of one cluster, 32 clusters, 32 functions with tilted frames; any model and weight
// anywhere, the same for the same members.
SpmmPtr bench_material(const BenchMaterial& what);

// Puts it, or so many of consecutive seeds, on the parts of the project in turn, in the place of all materials.
void dress(Project& project, const BenchMaterial& what, int materials = 1);

}  // namespace vamp
