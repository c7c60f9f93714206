#pragma once
// Weights and residuals as the tables of a material.
#include "engine/fit/residual.h"

namespace vamp::fit {

// A weight as a material stores it.
float stored(float weight);

Spmm bake(const Measurement& measurement, const std::vector<Basis>& dictionary,
          const std::vector<TexelWeights>& weights, const Clustering& clustering, const ResidualFit* residual,
          size_t terms);

}  // namespace vamp::fit
