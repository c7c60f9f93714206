#pragma once
// Functions of a dictionary over all (view, light) pairs of a measurement: the columns of a fit's design.
#include <span>
#include <vector>

#include "engine/core/vec.h"
#include "engine/material/spmm.h"

namespace vamp::fit {

// The pairs of a measurement, light fastest: pair = view * lights.size() + light.
struct Pairs {
  std::vector<vec3> views, lights;  // unit, above the horizon, in the texel's frame
  size_t count() const { return views.size() * lights.size(); }
};

// out[pair] = rho(wi, wo) of a basis with the cuts and windows of the renderer, times factor[pair] where that is not
// null; in float, from the text that the GPU runs.
void evaluate_column(const Basis& basis, const Pairs& pairs, const float* factor, float* out);

}  // namespace vamp::fit
