#pragma once
// Weights and residuals as the tables of a material.
#include "engine/fit/residual.h"

namespace vamp::fit {

// Stored numbers are rounded to multiples of a power of two that changes values by less than what the fit leaves
// anyway: what lies below that is noise to the file's packing, half of its bytes. All roundings of a material together
// raise its error by less than a hundredth of itself.
struct Step {
  float size = 0;  // 0: as fine as halves go
  // The greatest power of two that is at most `limit`.
  static Step at_most(double limit);
};

// A weight as a material stores it.
float stored(float weight, Step step);

// All weights as a material stores them, by the steps of their functions.
void round_weights(const std::vector<Step>& steps, std::vector<TexelWeights>& weights);

// The steps of a dictionary's weights where the functions leave `error`, a root mean square of weighted values.
std::vector<Step> weight_steps(const Design& design, double error);

// `error`: what the material leaves, as above; the residual's tables and coefficients are rounded by it.
Spmm bake(const Measurement& measurement, const std::vector<Basis>& dictionary,
          const std::vector<TexelWeights>& weights, const Clustering& clustering, const ResidualFit* residual,
          size_t terms, double error);

// What each cluster's functions reflect of light from everywhere.
std::vector<vec3> cluster_colours(const Spmm& spmm);

}  // namespace vamp::fit
