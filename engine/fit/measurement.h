#pragma once
// A BTF as a fit reads it: which of its directions take part, how much each pair counts, texels as rows of floats.
#include <cstdint>
#include <vector>

#include "engine/btf/btf.h"
#include "engine/fit/columns.h"

namespace vamp::fit {

class Measurement {
 public:
  // `mix`: 1 weighs pairs by the projected solid angles that their directions stand for, 0 all the same; half and half
  // was best between the samples (docs/fitting.md). Rings whose polar angle lies within 1 degree of one of `left_out`
  // (degrees) take no part. The BTF must outlive this.
  explicit Measurement(const Btf& btf, double mix = 0.5, const std::vector<double>& left_out = {});

  const Btf& btf() const { return *btf_; }
  size_t texels() const { return btf_->texel_count(); }
  const Pairs& pairs() const { return pairs_; }
  size_t pair_count() const { return roots_.size(); }
  size_t values() const { return 3 * roots_.size(); }
  // Square root of each pair's weight; the weights' mean is 1.
  const std::vector<float>& roots() const { return roots_; }
  // Mean distance of a direction to its nearest neighbour, radians.
  double spacing() const { return spacing_; }

  // One texel as values() floats, [channel][pair], each times its root.
  void read(size_t texel, float* out) const;

 private:
  const Btf* btf_;
  Pairs pairs_;
  std::vector<size_t> view_slots_, light_slots_;  // in the BTF
  bool all_lights_ = true;
  std::vector<float> roots_;
  double spacing_ = 0;
};

// bad_input for what lobes cannot stand for (signed logarithms), too few directions, too many texels.
Status check_measurement(const Btf& btf);

// Only what is measured under the same directions on both sides has a residual table.
bool can_have_residual(const Measurement& measurement);

// Projected solid angle (sum pi) of the hemisphere's part that lies nearest to each direction.
std::vector<double> projected_weights(const std::vector<vec3>& directions);

}  // namespace vamp::fit
