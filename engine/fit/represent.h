#pragma once
// A material or a truncated SVD as values under any directions: what quality.h compares with a measurement.
#include <array>
#include <vector>

#include "engine/fit/coordinates.h"
#include "engine/material/edit_layer.h"
#include "engine/material/tables.h"

namespace vamp::fit {

// Where directions fall between those of a direction set: three slots and their weights each.
struct Interpolation {
  std::vector<std::array<int, 3>> slots;
  std::vector<std::array<float, 3>> weights;
};
Result<Interpolation> interpolate(const std::vector<vec3>& from, const std::vector<vec3>& to);

// Rows over the pairs of `from` (both sides the same set), [channel][pair], read at other pairs; past the last ring
// light fades as the renderer fades it.
Result<Rows> resample(const Rows& rows, const std::vector<vec3>& from, const Pairs& to);

// A material's functions and residual over some pairs, after edits.
class SpmmValues {
 public:
  // The material must outlive it.
  static Result<SpmmValues> make(const Spmm& spmm, const Pairs& pairs, const EditLayer& edits = {});

  // The functions alone, [channel][pair].
  void functions(size_t texel, float* out) const;
  // Adds the residual's mean (k = 0) or its term k from 1 up.
  void add_residual(size_t texel, int k, float* out) const;
  int terms() const { return terms_; }  // -1: there is no residual

 private:
  const Spmm* spmm_ = nullptr;
  int terms_ = -1;
  Rows columns_;                     // one a basis, then one a row of the edit layer that has another shape
  std::vector<uint32_t> column_of_;  // [cluster][basis]
  std::vector<vec3> gains_;          // [cluster][basis]
  Rows residual_;                    // [cluster][mean, terms]
};

}  // namespace vamp::fit
