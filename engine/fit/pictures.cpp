#include "engine/fit/pictures.h"

#include <algorithm>
#include <cmath>
#include <random>

#include "engine/btf/picture_curve.h"
#include "engine/image/metrics.h"

namespace vamp::fit {
namespace {

constexpr size_t kPictures = 10;
constexpr int kSmallest = 22;  // texels a side: MSSIM's window of 11 pixels at two texels each

struct Picture {
  int width = 0, height = 0;
  std::vector<float> rgb;
};

// Two texels a pixel.
Picture halved(const Picture& p) {
  Picture out{p.width / 2, p.height / 2, {}};
  for (int y = 0; y < out.height; ++y)
    for (int x = 0; x < out.width; ++x)
      for (int c = 0; c < 3; ++c) {
        const auto at = [&](int i, int j) {
          return p.rgb[static_cast<size_t>(((2 * y + j) * p.width + 2 * x + i) * 3 + c)];
        };
        out.rgb.push_back((at(0, 0) + at(1, 0) + at(0, 1) + at(1, 1)) / 4);
      }
  return out;
}

float displayed(float linear) { return static_cast<float>(code_of(std::min(double{linear}, 1.0), PictureCurve::srgb)); }

std::vector<float> display(const Picture& p, float white) {
  std::vector<float> out;
  for (const float v : p.rgb) out.push_back(displayed(v / white));
  return out;
}

// Luminance as a display shows it.
std::vector<float> grey(const Picture& p, float white) {
  std::vector<float> out;
  for (size_t i = 0; i < p.rgb.size(); i += 3)
    out.push_back(displayed((0.2126f * std::max(p.rgb[i], 0.f) + 0.7152f * std::max(p.rgb[i + 1], 0.f) +
                             0.0722f * std::max(p.rgb[i + 2], 0.f)) /
                            white));
  return out;
}

float percentile(std::vector<float> values, double share) {
  const auto place = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), place, values.end());
  return std::max(*place, 1e-6f);
}

void add(const Picture& seen, const Picture& truth, float white, double& psnr_sum, double& mssim_sum) {
  psnr_sum += std::min(psnr(display(seen, white), display(truth, white)), 100.0);
  mssim_sum += mssim(grey(seen, white), grey(truth, white), seen.width, seen.height).value_or(0);
}

}  // namespace

Pictures::Pictures(const Pairs& pairs, int width, int height, size_t representations)
    : pairs_(pairs.count()), width_(width), height_(height), seen_(representations) {
  if (std::min(width, height) < kSmallest) return;
  std::vector<size_t> good;
  for (size_t v = 0; v < pairs.views.size(); ++v)
    for (size_t l = 0; l < pairs.lights.size(); ++l)
      if (pairs.views[v].z > 0.3f && pairs.lights[l].z > 0.3f) good.push_back(v * pairs.lights.size() + l);
  std::mt19937 random(1);
  for (size_t i = 0; i < kPictures && !good.empty(); ++i) chosen_.push_back(good[random() % good.size()]);
  const size_t values = chosen_.size() * static_cast<size_t>(width) * static_cast<size_t>(height) * 3;
  truth_.resize(values);
  for (auto& each : seen_) each.resize(values);
}

void Pictures::set_in(std::vector<float>& pictures, size_t texel, const float* values) {
  const size_t texels = static_cast<size_t>(width_) * static_cast<size_t>(height_);
  for (size_t i = 0; i < chosen_.size(); ++i)
    for (size_t c = 0; c < 3; ++c) pictures[(i * texels + texel) * 3 + c] = values[c * pairs_ + chosen_[i]];
}

void Pictures::compare(size_t representation, double& psnr, double& mssim, double& half_psnr,
                       double& half_mssim) const {
  psnr = mssim = half_psnr = half_mssim = 0;
  const auto size = static_cast<std::ptrdiff_t>(width_) * height_ * 3;
  for (size_t i = 0; i < chosen_.size(); ++i) {
    const auto picture = [&](const std::vector<float>& from) {
      const auto first = from.begin() + static_cast<std::ptrdiff_t>(i) * size;
      return Picture{width_, height_, std::vector<float>(first, first + size)};
    };
    const Picture truth = picture(truth_), seen = picture(seen_[representation]);
    const float white = percentile(truth.rgb, 0.995);
    add(seen, truth, white, psnr, mssim);
    add(halved(seen), halved(truth), white, half_psnr, half_mssim);
  }
  if (chosen_.empty()) return;
  for (double* each : {&psnr, &mssim, &half_psnr, &half_mssim}) *each /= static_cast<double>(chosen_.size());
}

}  // namespace vamp::fit
