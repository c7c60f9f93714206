#include "engine/material/highlight.h"

#include <algorithm>
#include <cmath>

namespace vamp {
namespace {

float width_of_exponent(float n) { return std::sqrt(2 / (n + 2)); }

}  // namespace

std::optional<float> highlight_slopes(const Lobe& lobe) {
  const auto& p = lobe.params;
  switch (lobe.model) {
    case Model::blinn_phong:
      return width_of_exponent(p[1]);
    case Model::ward:
      return std::max(p[1], p[2]);
    case Model::cook_torrance:
      return p[1];
    case Model::lafortune:
      // A cosine about the mirrored viewer turns twice as fast as the half vector.
      if (p[1] < 0 && p[2] < 0 && p[3] > 0) return width_of_exponent(4 * p[4]);
      return {};
    case Model::ashikhmin_shirley:
      if (lobe.variant == kAshikhminShirleyDiffuse) return {};
      return width_of_exponent(std::min(p[2], p[3]));
    default:
      return {};
  }
}

float highlight_width(const Spmm& spmm, const FitSums& sums) {
  const size_t bases = spmm.dictionary.size();
  std::vector<double> light(bases, 0.0);
  double all = 0;
  for (size_t row = 0; row < sums.weights.size(); ++row) {
    const dvec3& w = sums.weights[row];
    const double share = (w.r + w.g + w.b) * sums.normal_albedo[row % bases];
    light[row % bases] += share;
    all += share;
  }
  float width = 0;
  for (size_t j = 0; j < bases; ++j) {
    const Basis& basis = spmm.dictionary[j];
    const auto slopes = highlight_slopes(basis.lobe);
    if (!slopes || light[j] <= 0.01 * all) continue;
    // A tilted function stands beside the mirror direction by its own slope.
    const float tilt = std::hypot(basis.normal.x, basis.normal.y) / std::max(basis.normal.z, 1e-3f);
    const float spread = std::hypot(*slopes, tilt);
    if (spread <= kSharpSlopes) width = std::max(width, spread);
  }
  return width;
}

}  // namespace vamp
