#include "engine/fit/lobe_fit.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/fit/measurement.h"
#include "tests/fit/synthetic.h"

namespace vamp::fit {
namespace {

double correlation(const float* a, const float* b, size_t n) {
  double ab = 0, aa = 0, bb = 0;
  dot_rows(a, 1, b, 1, n, &ab), dot_rows(a, 1, a, 1, n, &aa), dot_rows(b, 1, b, 1, n, &bb);
  return ab / std::sqrt(aa * bb);
}

// Nothing is known but the sum of three lobes: 85 % of them are found to a correlation of 0.995, and the sums to 2 %.
TEST(LobeFit, FindsLobesBlindly) {
  constexpr size_t kTexels = 24, kFunctions = 3;
  const test::Synthetic truth = test::random_synthetic(7, kTexels, 20, kFunctions);
  const Btf btf = test::measure(truth, kTexels, 1);
  const Measurement measurement(btf);
  const LobeLimits limits = LobeLimits::for_spacing(measurement.spacing());
  const LobeLibrary library = make_lobe_library(measurement.pairs(), measurement.roots(), limits);
  LobeFitOptions options;
  options.max_lobes = kFunctions + 3;
  std::vector<float> row(measurement.values());
  Rows columns(2, measurement.pair_count());
  size_t matched = 0;
  double error = 0;
  for (size_t t = 0; t < kTexels; ++t) {
    measurement.read(t, row.data());
    const LobeFit fit = fit_lobes(measurement.pairs(), measurement.roots(), library, limits, row.data(), options);
    error += fit.relative_error;
    for (const int j : truth.texels[t].support) {
      evaluate_column(truth.dictionary[static_cast<size_t>(j)], measurement.pairs(), measurement.roots().data(),
                      columns.row(0));
      double best = 0;
      for (const Basis& basis : fit.bases) {
        evaluate_column(basis, measurement.pairs(), measurement.roots().data(), columns.row(1));
        best = std::max(best, correlation(columns.row(0), columns.row(1), columns.length));
      }
      matched += best > 0.995 ? 1u : 0u;
    }
  }
  EXPECT_GE(static_cast<double>(matched), 0.85 * kTexels * kFunctions);
  EXPECT_LE(error / kTexels, 0.02);
}

TEST(LobeFit, OfABlackTexelIsEmpty) {
  const std::vector<vec3> directions = {{0, 0, 1}, {0.6f, 0, 0.8f}, {0, 0.6f, 0.8f}};
  const Pairs pairs = {directions, directions};
  const std::vector<float> roots(9, 1.f), zeros(27, 0.f);
  const LobeLibrary library = make_lobe_library(pairs, roots, LobeLimits());
  const LobeFit fit = fit_lobes(pairs, roots, library, LobeLimits(), zeros.data(), {});
  EXPECT_TRUE(fit.bases.empty());
  EXPECT_EQ(fit.relative_error, 0);
}

}  // namespace
}  // namespace vamp::fit
