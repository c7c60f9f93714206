#pragma once
// Two older representations to compare with: one Blinn-Phong lobe a texel, and the spatial reflectance field of Ma et
// al. 2004 (one Blinn-Phong for the material and, per texel and channel, a shape s whose product with the half vector
// is added). Both in radiance, the cosine included, as Ma's equation 3 has it.
#include <array>
#include <vector>

#include "engine/fit/measurement.h"
#include "engine/fit/parallel.h"
#include "engine/fit/rows.h"

namespace vamp::fit {

class SimpleModels {
 public:
  // One pass over the measurement.
  SimpleModels(const Measurement& measurement, const Worker& worker);

  // Columns of both models at other pairs, for the two functions below.
  Rows columns_at(const Pairs& pairs) const;
  // Values at the pairs of `columns`, [channel][pair].
  void blinn_phong(size_t texel, const Rows& columns, float* out) const;
  void srf(size_t texel, const Rows& columns, float* out) const;

 private:
  struct Phong {
    std::array<float, 3> diffuse{}, highlight{};
    size_t exponent = 0;
  };
  static Phong best_phong(const std::vector<double>& gram, const double* correlations);

  std::vector<Phong> texels_;
  Phong mean_;
  std::vector<std::array<float, 9>> shapes_;  // [channel][x, y, z]
};

}  // namespace vamp::fit
