#pragma once
// One texel under all directions: its values and how sure they are.
#include <span>
#include <vector>

#include "engine/acquire/acquire.h"

namespace vamp::acquire {

class TexelMeter {
 public:
  // All three must outlive it. One for each thread.
  TexelMeter(const Goniometer& goniometer, const std::vector<vec3>& views, const Options& options);

  // Measures texel (x, y); which random numbers it draws depends on the texel and the seed alone. Returns the relative
  // standard error (Report).
  float measure(size_t x, size_t y);

  // [view][light][channel], ReflectedCos.
  std::span<const float> values() const { return values_; }

 private:
  // Returns the sum over lights and channels of the squared standard error.
  double measure_view(size_t x, size_t y, size_t view, std::span<float> mean);

  const Goniometer& goniometer_;
  const std::vector<vec3>& views_;
  const Options& options_;
  int columns_ = 1;  // of strata
  std::vector<float> values_;
  std::vector<float> sample_, before_;
  std::vector<double> sum_;
};

}  // namespace vamp::acquire
