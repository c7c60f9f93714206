#pragma once
// How far a picture is from a reference.
#include <span>

#include "engine/image/image.h"

namespace vamp {

// Over equally long rows of values, a measured against the reference r. All sums in double.
double rmse(std::span<const float> a, std::span<const float> r);       // sqrt(mean((a - r)^2))
double rel_mse(std::span<const float> a, std::span<const float> r);    // mean((a - r)^2 / (r^2 + 0.01))
double max_error(std::span<const float> a, std::span<const float> r);  // max |a - r|
double psnr(std::span<const float> a, std::span<const float> r);  // 10 log10(1 / mse) dB, peak 1; infinite when equal

// Mean structural similarity (Wang, Bovik, Sheikh, Simoncelli 2004, equation 13): Gaussian window 11 x 11 with
// sigma 1.5 whose weights sum to 1, K1 = 0.01, K2 = 0.03, L = 1, only windows that lie inside the picture. Values in
// [0, 1], rows of `width`. Nothing when a side is under 11 pixels.
std::optional<double> mssim(std::span<const float> a, std::span<const float> r, int width, int height);

}  // namespace vamp
