#pragma once
// What fewer functions cost: error against functions a texel and functions of the whole material.
#include "engine/fit/coding.h"

namespace vamp::fit {

struct CurvePoint {
  size_t bases = 0;      // of the material: the first so many of its dictionary, which lists the most useful first
  double functions = 0;  // a texel, in the mean
  double error = 0;      // relative RMSE of the functions alone
};

// For 4, 8, 12, 16, 24, 32, 48 .. and all functions of the dictionary, and 1, 2, 3, 5, 8 and `most` a texel as far as
// those go. A dictionary that was made for a smaller size is a little better than the first functions of a larger one.
// Codes the texels once for each size. `square` is that of all texels.
std::vector<CurvePoint> sparsity_curve(const Measurement& measurement, const Design& design, size_t most, double square,
                                       const Worker& worker);

}  // namespace vamp::fit
