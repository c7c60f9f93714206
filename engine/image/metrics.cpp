#include "engine/image/metrics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "engine/core/check.h"

namespace vamp {
namespace {

// The mean over both rows of values of f(a, r).
template <class F>
double mean(std::span<const float> a, std::span<const float> r, const F& f) {
  CHECK(a.size() == r.size() && !a.empty());
  double sum = 0;
  for (size_t i = 0; i < a.size(); ++i) sum += f(static_cast<double>(a[i]), static_cast<double>(r[i]));
  return sum / static_cast<double>(a.size());
}

double squared_difference(double a, double r) { return (a - r) * (a - r); }

constexpr int kWindow = 11;

std::array<double, kWindow> gaussian() {
  std::array<double, kWindow> weights{};
  double sum = 0;
  for (int i = 0; i < kWindow; ++i)
    sum += weights[static_cast<size_t>(i)] = std::exp(-(i - 5) * (i - 5) / (2 * 1.5 * 1.5));
  for (double& w : weights) w /= sum;
  return weights;
}

// The five moments that SSIM needs, of one place or of sums over a window.
struct Moments {
  double a = 0, r = 0, aa = 0, rr = 0, ar = 0;

  void add(double weight, const Moments& m) {
    a += weight * m.a;
    r += weight * m.r;
    aa += weight * m.aa;
    rr += weight * m.rr;
    ar += weight * m.ar;
  }
};

double ssim(const Moments& m) {
  constexpr double kC1 = 0.01 * 0.01;
  constexpr double kC2 = 0.03 * 0.03;
  const double var_a = m.aa - m.a * m.a;
  const double var_r = m.rr - m.r * m.r;
  const double covariance = m.ar - m.a * m.r;
  return (2 * m.a * m.r + kC1) * (2 * covariance + kC2) / ((m.a * m.a + m.r * m.r + kC1) * (var_a + var_r + kC2));
}

}  // namespace

double rmse(std::span<const float> a, std::span<const float> r) { return std::sqrt(mean(a, r, squared_difference)); }

double rel_mse(std::span<const float> a, std::span<const float> r) {
  return mean(a, r, [](double x, double y) { return squared_difference(x, y) / (y * y + 0.01); });
}

double max_error(std::span<const float> a, std::span<const float> r) {
  double most = 0;
  mean(a, r, [&most](double x, double y) { return most = std::max(most, std::abs(x - y)); });
  return most;
}

double psnr(std::span<const float> a, std::span<const float> r) {
  const double mse = mean(a, r, squared_difference);
  return mse > 0 ? -10.0 * std::log10(mse) : std::numeric_limits<double>::infinity();
}

std::optional<double> mssim(std::span<const float> a, std::span<const float> r, int width, int height) {
  CHECK(a.size() == r.size() && a.size() == static_cast<size_t>(width) * static_cast<size_t>(height));
  if (width < kWindow || height < kWindow) return std::nullopt;
  const auto weights = gaussian();
  const auto columns = static_cast<size_t>(width - kWindow + 1);
  // The Gaussian is separable: each row is filtered once and kept while windows reach it.
  std::vector<Moments> kept(columns * kWindow);
  double sum = 0;
  for (int y = 0; y < height; ++y) {
    Moments* filtered = kept.data() + columns * static_cast<size_t>(y % kWindow);
    const size_t row = static_cast<size_t>(y) * static_cast<size_t>(width);
    for (size_t x = 0; x < columns; ++x) {
      Moments moments;
      for (size_t i = 0; i < kWindow; ++i) {
        const auto p = static_cast<double>(a[row + x + i]);
        const auto q = static_cast<double>(r[row + x + i]);
        moments.add(weights[i], {p, q, p * p, q * q, p * q});
      }
      filtered[x] = moments;
    }
    if (y + 1 < kWindow) continue;
    for (size_t x = 0; x < columns; ++x) {
      Moments moments;
      for (int i = 0; i < kWindow; ++i)
        moments.add(weights[static_cast<size_t>(i)], kept[columns * static_cast<size_t>((y + 1 + i) % kWindow) + x]);
      sum += ssim(moments);
    }
  }
  return sum / (static_cast<double>(columns) * (height - kWindow + 1));
}

}  // namespace vamp
