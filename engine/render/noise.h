#pragma once
// How noisy a progressive picture still is, from the picture alone.
#include <cstdint>
#include <vector>

namespace vamp {

// Compares the mean at n samples with the mean at n / 2: their difference is half the difference of two means over n /
// 2 samples each, and so has the standard error of the mean at n. For scrambled Sobol points, whose halves complement
// each other, it over-estimates. The result is relative like relMSE: sqrt(mean(d^2 / (luminance^2 + 0.01))).
class NoiseEstimate {
 public:
  void restart();
  // The pictures to come are of something else, but about as noisy.
  void forget_picture() { luminance_.clear(); }
  // Whether a picture of this many samples is wanted (powers of two from 4).
  bool wants(uint32_t samples) const;
  // `linear`: RGBA, the same size each time.
  void add(uint32_t samples, const std::vector<float>& linear);
  // At `samples`, falling with the square root since the last comparison; -1: not known yet.
  float at(uint32_t samples) const;

 private:
  std::vector<float> luminance_;
  uint32_t samples_ = 0;        // that luminance_ was taken at
  float noise_ = -1;            // at noise_samples_
  uint32_t noise_samples_ = 0;  // of the last comparison
};

}  // namespace vamp
