#include "engine/acquire/texel.h"

#include <algorithm>
#include <cmath>

namespace vamp::acquire {

TexelMeter::TexelMeter(const Goniometer& goniometer, const std::vector<vec3>& views, const Options& options)
    : goniometer_(goniometer), views_(views), options_(options) {
  const size_t values = 3 * goniometer.light_count();
  values_.resize(views.size() * values);
  sample_.resize(values), before_.resize(values), sum_.resize(values);
  // As square as the number of samples allows.
  for (int i = 1; i * i <= options.samples; ++i)
    if (options.samples % i == 0) columns_ = options.samples / i;
}

float TexelMeter::measure(size_t x, size_t y) {
  const size_t count = sample_.size();
  double error2 = 0, value2 = 0;
  for (size_t v = 0; v < views_.size(); ++v)
    error2 += measure_view(x, y, v, std::span(values_).subspan(v * count, count));
  for (const float value : values_) value2 += static_cast<double>(value) * static_cast<double>(value);
  return value2 > 0 ? static_cast<float>(std::sqrt(error2 / value2)) : 0;
}

double TexelMeter::measure_view(size_t x, size_t y, size_t view, std::span<float> mean) {
  const size_t count = sample_.size();
  const int samples = options_.samples, rows = samples / columns_;
  const uint64_t texel = y * static_cast<size_t>(options_.size) + x;
  std::fill(sum_.begin(), sum_.end(), 0.0);
  double differences = 0;
  // Strata are walked like an ox ploughs, so that the one before is a neighbour.
  for (int s = 0; s < samples; ++s) {
    const int row = s / columns_, in_row = s % columns_;
    const int column = row % 2 == 0 ? in_row : columns_ - 1 - in_row;
    Random random(hash_bits(options_.seed, texel, view, static_cast<uint64_t>(s)));
    const float u = (static_cast<float>(column) + random.next()) / static_cast<float>(columns_);
    const float v = (static_cast<float>(row) + random.next()) / static_cast<float>(rows);
    std::fill(sample_.begin(), sample_.end(), 0.0f);
    const auto size = static_cast<float>(options_.size);
    goniometer_.trace(vec2((static_cast<float>(x) + u) / size, (static_cast<float>(y) + v) / size), views_[view],
                      random, sample_);
    float difference = 0;
    for (size_t i = 0; i < count; ++i) {
      sum_[i] += static_cast<double>(sample_[i]);
      const float d = sample_[i] - before_[i];
      difference += d * d;
    }
    if (s > 0) differences += static_cast<double>(difference);
    std::swap(sample_, before_);
  }
  for (size_t i = 0; i < count; ++i) mean[i] = static_cast<float>(sum_[i] / samples);
  // Half the mean squared difference of neighbours is a stratum's variance; the mean of n has an n-th of it.
  return samples > 1 ? differences / (2.0 * (samples - 1) * samples) : 0;
}

}  // namespace vamp::acquire
