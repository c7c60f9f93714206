#pragma once
// The colour models of Bonn's decorrelated factorisations, and what comes out of them as linear Rec.709.
#include <array>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace vamp {

// Numbers as they stand in files; 2 (CIELAB), 6, 7 and 8 are in no public data and not
// read: of 6, "spectral linear", the one public reader contradicts itself.
enum class ColourModel : int {
  rgb = 0,
  yuv = 1,
  pca = 3,  // values * matrix + mean
  ycocg = 4,
  spectral = 5,        // the sum, then the share of each channel after the first
  log_y_uv = 9,        // log(Y + e), U, V
  log_y_log_uv = 10,   // log(Y + e), sign(U) log(|U| / e), the same of V
  log_y_uv_by_y = 11,  // log(Y + e), U / (Y + e), V / (Y + e): the one of UBO2014
  log_rgb = 12,        // log(R + e), ...
};

std::optional<ColourModel> colour_model(int number);
// "log Y, U / Y, V / Y".
std::string name_of(ColourModel model);

// The e that is added before logarithms are taken.
inline constexpr double kLogOffset = 1e-5;

struct ColourTransform {
  ColourModel model = ColourModel::rgb;
  std::array<float, 3> mean{};                             // of pca
  std::array<float, 9> matrix{1, 0, 0, 0, 1, 0, 0, 0, 1};  // of pca, row-major
};

// Undoes the model in place; three values, or one for each channel of the spectral models and of rgb and log_rgb.
// Arithmetic in double; huge logarithms come out as infinity.
void undo(const ColourTransform& transform, std::span<double> values);

// Row-major 3 x N matrix from reflectances at these wavelengths (nm, rising) to linear Rec.709: what the CIE 1931
// observer sees under equal-energy light, adapted to D65; a flat spectrum of 1 gives (1, 1, 1).
std::vector<double> rec709_from_wavelengths(std::span<const double> nm);

}  // namespace vamp
