#include "engine/render/noise.h"

#include <bit>
#include <cmath>

namespace vamp {

void NoiseEstimate::restart() {
  luminance_.clear();
  samples_ = 0;
  noise_ = -1;
}

bool NoiseEstimate::wants(uint32_t samples) const {
  return samples >= 4 && std::has_single_bit(samples) && samples != samples_;
}

void NoiseEstimate::add(uint32_t samples, const std::vector<float>& linear) {
  std::vector<float> now(linear.size() / 4);
  double sum = 0;
  const bool comparable = luminance_.size() == now.size() && samples == 2 * samples_;
  for (size_t i = 0; i < now.size(); ++i) {
    // Rec.709 luminance.
    now[i] = 0.2126f * linear[4 * i] + 0.7152f * linear[4 * i + 1] + 0.0722f * linear[4 * i + 2];
    if (!comparable) continue;
    const double d = static_cast<double>(now[i]) - static_cast<double>(luminance_[i]);
    sum += d * d / (static_cast<double>(now[i]) * static_cast<double>(now[i]) + 0.01);
  }
  if (comparable) {
    noise_ = static_cast<float>(std::sqrt(sum / static_cast<double>(now.size())));
    noise_samples_ = samples;
  }
  luminance_ = std::move(now);
  samples_ = samples;
}

float NoiseEstimate::at(uint32_t samples) const {
  if (noise_ < 0 || samples == 0) return -1;
  return noise_ * std::sqrt(static_cast<float>(noise_samples_) / static_cast<float>(samples));
}

}  // namespace vamp
