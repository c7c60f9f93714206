#pragma once
// From a goniometer to an SPMM: weights of a given dictionary for every texel, then what they leave over as a mean and
// four PCA terms for each cluster.
#include <Eigen/Core>
#include <vector>

#include "tools/presets/goniometer.h"
#include "tools/presets/surface.h"

namespace vamp::presets {

inline constexpr int kPairs = kDirections * kDirections;  // pair = view * 81 + light

struct ParametricFit {
  Eigen::MatrixXf shapes;                 // [basis, pair]: fcos with SPMM's cuts and windows
  std::vector<Eigen::MatrixX3f> weights;  // per texel, [basis, channel], at most max_entries rows not 0
  std::vector<bool> glossy;               // per basis: serves the finish, not the body
  std::vector<Eigen::Matrix3Xf> mean;     // per cluster, [channel, pair]: mean of the body minus its parametric part
  double error = 0;                       // relative RMSE of the parametric part, weighted
};

// Least squares over all 81 x 81 directions with non-negative weights, weighted half by projected solid angle, half
// uniformly; functions that matter least are dropped until `max_entries` are left for the body and as many for the
// finish. Body and finish are fitted apart, each by its own models: so colours stay in the body, and the finish is
// carried by lobes alone. A residual over directions 15 degrees apart cannot hold a highlight narrower than that.
ParametricFit fit_parametric(const Surface& surface, const Goniometer& goniometer, int max_entries);

// What a texel's body keeps after its parametric part, [channel, pair].
Eigen::Matrix3Xf body_leftover(const Goniometer& goniometer, const ParametricFit& fit, int texel);

struct ResidualFit {
  Residual residual;
  std::vector<Eigen::Vector4f> coefficients;  // per texel
};
ResidualFit fit_residual(const Surface& surface, const Goniometer& goniometer, const ParametricFit& fit);

// The material that the fits come to, rounded as files keep it.
Spmm bake(const Surface& surface, const ParametricFit& parametric, const ResidualFit& residual);

// Square root of each pair's weight in the fit.
Eigen::RowVectorXf pair_weights();

}  // namespace vamp::presets
