#pragma once
// An alternative to a mean and four terms for each cluster: one residual basis for the whole material. Measured beside
// it (quality.h), not stored: it needs 16 to 32 terms where the kernels read four.
#include "engine/fit/coordinates.h"
#include "engine/fit/measurement.h"
#include "engine/material/spmm.h"

namespace vamp::fit {

// What a material's functions leave of texel t is close to the sum over k of coordinates[t][k] * row k of rotated(D),
// where D are the rows of `svd` that it was made from (or those rows under other directions); by falling energy.
class SharedResidual {
 public:
  SharedResidual(const Coordinates& svd, const Measurement& source, const Spmm& spmm);

  const Rows& coordinates() const { return coordinates_; }
  Rows rotated(const Rows& directions) const;

 private:
  Rows coordinates_;
  std::vector<float> axes_;  // [axis][rank]
};

}  // namespace vamp::fit
