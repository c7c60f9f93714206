#include "engine/fit/curve.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace vamp::fit {
namespace {

double mean_of(const std::vector<size_t>& counts) {
  return static_cast<double>(std::accumulate(counts.begin(), counts.end(), size_t{0})) /
         static_cast<double>(counts.size());
}

// The counts at the price for which texels have `functions` in the mean, or fewer where they need no more.
std::vector<size_t> counts_for(const std::vector<TexelCode>& codes, double functions, double square) {
  double low = 0, high = square;  // prices
  std::vector<size_t> counts = counts_at(codes, 0);
  if (mean_of(counts) <= functions) return counts;
  for (int i = 0; i < 60; ++i) {
    // Prices span many powers of ten.
    const double middle = low > 0 ? std::sqrt(low * high) : high * 1e-3;
    counts = counts_at(codes, middle);
    (mean_of(counts) > functions ? low : high) = middle;
    if (low == 0 && middle < 1e-15 * square) break;
  }
  return counts_at(codes, high);
}

}  // namespace

std::vector<CurvePoint> sparsity_curve(const Measurement& measurement, const Design& design, size_t most, double square,
                                       const Worker& worker) {
  const size_t all = design.columns.count;
  std::vector<size_t> sizes;
  for (const size_t size : {4, 8, 12, 16, 24, 32, 48, 64, 96, 128, 192, 256, 384, 512, 768})
    if (size < all) sizes.push_back(size);
  sizes.push_back(all);
  const std::vector<uint16_t> one_group(measurement.texels(), 0);
  std::vector<CurvePoint> curve;
  for (const size_t size : sizes) {
    worker.stage(fmt::format("Coding with {} functions", size));
    std::vector<int> first(size);
    std::iota(first.begin(), first.end(), 0);
    const size_t at_most = std::min(most, size);
    const auto codes = code_texels(measurement, design, {{first}, &one_group}, Coder::elimination, at_most, worker);
    if (worker.cancelled()) return curve;
    for (const size_t functions : {1, 2, 3, 5, 8})
      if (functions < at_most) {
        const std::vector<size_t> counts = counts_for(codes, static_cast<double>(functions), square);
        curve.push_back({size, mean_of(counts), std::sqrt(error_of(codes, counts) / square)});
      }
    const std::vector<size_t> counts = counts_at(codes, 0);
    curve.push_back({size, mean_of(counts), std::sqrt(error_of(codes, counts) / square)});
  }
  return curve;
}

}  // namespace vamp::fit
