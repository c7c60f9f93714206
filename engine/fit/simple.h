#pragma once
// Two older representations to compare with: one Blinn-Phong lobe a texel, and the spatial reflectance field of Ma et
// al. 2004 (one Blinn-Phong for the material and, per texel and channel, a shape s whose product with the half vector
// is added). Both in radiance, the cosine included, as Ma's equation 3 has it.
#include <Eigen/Core>
#include <array>
#include <vector>

#include "engine/fit/measurement.h"
#include "engine/fit/parallel.h"
#include "engine/fit/rows.h"

namespace vamp::fit {

class SimpleModels {
 public:
  struct Phong {
    std::array<float, 3> diffuse{}, highlight{};
    size_t exponent = 0;  // of those that are tried
  };
  // Where the half vector's three columns begin.
  static const size_t kHalf;

  // One pass over the measurement.
  SimpleModels(const Measurement& measurement, const Worker& worker);

  // Columns of both models at other pairs, for the two functions below.
  Rows columns_at(const Pairs& pairs) const;
  // Values at the pairs of `columns`, [channel][pair].
  void blinn_phong(size_t texel, const Rows& columns, float* out) const;
  void srf(size_t texel, const Rows& columns, float* out) const;

  // The parts of the spatial reflectance field: Blinn-Phong of the whole material, s(P) as [channel][x, y, z].
  const Phong& mean() const { return mean_; }
  const float* shape(size_t texel) const { return shapes_[texel].data(); }
  // The column of the mean's highlight among these.
  const float* highlight_column(const Rows& columns) const;
  // Weighted products of the half vector's components over the measured pairs.
  const Eigen::Matrix3d& half_gram() const { return half_gram_; }

 private:
  static Phong best_phong(const std::vector<double>& gram, const double* correlations);

  std::vector<Phong> texels_;
  Phong mean_;
  std::vector<std::array<float, 9>> shapes_;
  Eigen::Matrix3d half_gram_;
};

}  // namespace vamp::fit
