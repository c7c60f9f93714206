#include "engine/btf/colour_model.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/core/check.h"

namespace vamp {
namespace {

constexpr std::pair<ColourModel, const char*> kNames[] = {
    {ColourModel::rgb, "RGB"},
    {ColourModel::yuv, "YUV"},
    {ColourModel::pca, "principal components of RGB"},
    {ColourModel::ycocg, "YCoCg"},
    {ColourModel::spectral, "spectral: sum and shares"},
    {ColourModel::log_y_uv, "log Y, U, V"},
    {ColourModel::log_y_log_uv, "log Y, log U, log V"},
    {ColourModel::log_y_uv_by_y, "log Y, U / Y, V / Y"},
    {ColourModel::log_rgb, "log RGB"},
};

// Row-major, as Bonn's own reader has them.
constexpr double kRgbFromYuv[9] = {1, 0, 1.13983, 1, -0.39465, -0.5806, 1, 2.03211, 0};
constexpr double kRgbFromYCoCg[9] = {1, 1, -1, 1, 0, 1, 1, -1, -1};

void multiply(const double (&m)[9], std::span<double> v) {
  const double a = v[0], b = v[1], c = v[2];
  for (size_t i = 0; i < 3; ++i) v[i] = m[3 * i] * a + m[3 * i + 1] * b + m[3 * i + 2] * c;
}

double from_log(double value) { return std::exp(value) - kLogOffset; }

// The first channel is what the others leave of the whole.
void undo_spectral(std::span<double> values) {
  const double sum = values[0];
  double first = 1;
  for (double& share : values.subspan(1)) {
    first -= share;
    share *= sum;
  }
  values[0] = first * sum;
}

// Wyman, Sloan, Shirley 2013, "Simple Analytic Approximations to the CIE XYZ Color Matching Functions", the multi-lobe
// fit of the 1931 observer.
double lobe(double nm, double centre, double below, double above) {
  const double t = (nm - centre) * (nm < centre ? below : above);
  return std::exp(-0.5 * t * t);
}
double observer_x(double nm) {
  return 0.362 * lobe(nm, 442.0, 0.0624, 0.0374) + 1.056 * lobe(nm, 599.8, 0.0264, 0.0323) -
         0.065 * lobe(nm, 501.1, 0.0490, 0.0382);
}
double observer_y(double nm) {
  return 0.821 * lobe(nm, 568.8, 0.0213, 0.0247) + 0.286 * lobe(nm, 530.9, 0.0613, 0.0322);
}
double observer_z(double nm) {
  return 1.217 * lobe(nm, 437.0, 0.0845, 0.0278) + 0.681 * lobe(nm, 459.0, 0.0385, 0.0725);
}

// ITU-R BT.709 with D65.
constexpr double kRec709FromXyz[9] = {3.2404542, -1.5371385, -0.4985314, -0.9692660, 1.8760108,
                                      0.0415560, 0.0556434,  -0.2040259, 1.0572252};
constexpr double kXyzFromRec709[9] = {0.4124564, 0.3575761, 0.1804375, 0.2126729, 0.7151522,
                                      0.0721750, 0.0193339, 0.1191920, 0.9503041};

}  // namespace

std::optional<ColourModel> colour_model(int number) {
  for (const auto& [model, name] : kNames)
    if (static_cast<int>(model) == number) return model;
  return {};
}

std::string name_of(ColourModel model) {
  for (const auto& [known, name] : kNames)
    if (known == model) return name;
  return {};
}

void undo(const ColourTransform& transform, std::span<double> values) {
  switch (transform.model) {
    case ColourModel::rgb:
      return;
    case ColourModel::spectral:
      return undo_spectral(values);
    case ColourModel::log_rgb:
      for (double& value : values) value = from_log(value);
      return;
    default:
      CHECK(values.size() == 3);
  }
  const double y = values[0];
  switch (transform.model) {
    case ColourModel::pca: {
      const std::array<double, 3> in{values[0], values[1], values[2]};
      for (size_t i = 0; i < 3; ++i) {
        values[i] = double{transform.mean[i]};
        for (size_t k = 0; k < 3; ++k) values[i] += in[k] * double{transform.matrix[3 * k + i]};
      }
      return;
    }
    case ColourModel::ycocg:
      return multiply(kRgbFromYCoCg, values);
    case ColourModel::log_y_uv:
      values[0] = from_log(y);
      break;
    case ColourModel::log_y_log_uv:
      values[0] = from_log(y);
      for (double& value : values.subspan(1)) value = std::copysign(std::exp(std::abs(value)) * kLogOffset, value);
      break;
    case ColourModel::log_y_uv_by_y:
      values[0] = from_log(y);
      for (double& value : values.subspan(1)) value *= std::exp(y);
      break;
    default:
      break;
  }
  multiply(kRgbFromYuv, values);
}

std::vector<double> rec709_from_wavelengths(std::span<const double> nm) {
  const size_t n = nm.size();
  std::vector<double> xyz(3 * n);
  double white[3] = {};
  for (size_t i = 0; i < n; ++i) {
    // The trapezoid rule: half of the way to either neighbour.
    const double width = n == 1 ? 1 : (nm[std::min(i + 1, n - 1)] - nm[i == 0 ? 0 : i - 1]) / 2;
    const double seen[3] = {observer_x(nm[i]), observer_y(nm[i]), observer_z(nm[i])};
    for (size_t c = 0; c < 3; ++c) white[c] += xyz[c * n + i] = seen[c] * width;
  }
  // Scaling X, Y and Z takes equal-energy white to Rec.709's own (von Kries in XYZ), so that grey stays grey.
  double rec709_white[3] = {0, 0, 0};
  for (size_t c = 0; c < 3; ++c)
    for (size_t k = 0; k < 3; ++k) rec709_white[c] += kXyzFromRec709[3 * c + k];
  std::vector<double> matrix(3 * n);
  for (size_t i = 0; i < n; ++i)
    for (size_t r = 0; r < 3; ++r)
      for (size_t c = 0; c < 3; ++c)
        matrix[r * n + i] += kRec709FromXyz[3 * r + c] * xyz[c * n + i] * rec709_white[c] / white[c];
  return matrix;
}

}  // namespace vamp
