#include "engine/fit/lasso.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "engine/fit/measurement.h"
#include "engine/fit/rows.h"
#include "tests/fit/synthetic.h"

namespace vamp::fit {
namespace {

constexpr size_t kBases = 10;

// One texel of a known dictionary in Gram space.
struct Problem {
  std::vector<double> gram = std::vector<double>(kBases * kBases),
                      correlations = std::vector<double>(kChannels * kBases);
  double square = 0;
  std::vector<int> support;
};

Problem make_problem(uint32_t seed) {
  const test::Synthetic truth = test::random_synthetic(seed, 1, kBases, 4);
  const Btf btf = test::measure(truth, 1, 1);
  const Measurement measurement(btf);
  Rows columns(kBases, measurement.pair_count());
  for (size_t j = 0; j < kBases; ++j)
    evaluate_column(truth.dictionary[j], measurement.pairs(), measurement.roots().data(), columns.row(j));
  Problem problem;
  problem.support = truth.texels[0].support;
  gram_rows(columns.row(0), kBases, columns.length, problem.gram.data());
  std::vector<float> row(measurement.values());
  measurement.read(0, row.data());
  dot_rows(row.data(), kChannels, columns.row(0), kBases, columns.length, problem.correlations.data());
  dot_rows(row.data(), 1, row.data(), 1, row.size(), &problem.square);
  return problem;
}

double penalty(const std::vector<double>& a) {
  double sum = 0;
  for (size_t j = 0; j < kBases; ++j)
    sum += std::sqrt(a[j] * a[j] + a[kBases + j] * a[kBases + j] + a[2 * kBases + j] * a[2 * kBases + j]);
  return sum;
}

double half_error(const Problem& problem, const std::vector<double>& a) {
  double error = problem.square;
  for (size_t c = 0; c < kChannels; ++c)
    for (size_t j = 0; j < kBases; ++j) {
      double sum = -2 * problem.correlations[c * kBases + j];
      for (size_t k = 0; k < kBases; ++k) sum += problem.gram[j * kBases + k] * a[c * kBases + k];
      error += a[c * kBases + j] * sum;
    }
  return error / 2;
}

TEST(GroupLasso, MeetsTheKarushKuhnTuckerConditions) {
  const Problem problem = make_problem(5);
  double largest = 0;
  for (const double c : problem.correlations) largest = std::max(largest, c);
  const double lambda = 0.05 * largest;
  std::vector<double> a(kChannels * kBases);
  group_lasso(problem.gram.data(), kBases, problem.correlations.data(), lambda, a);
  for (size_t j = 0; j < kBases; ++j) {
    double weight = 0, pull = 0, violation = 0;
    std::array<double, kChannels> g{};
    for (size_t c = 0; c < kChannels; ++c) {
      g[c] = problem.correlations[c * kBases + j];
      for (size_t k = 0; k < kBases; ++k) g[c] -= problem.gram[j * kBases + k] * a[c * kBases + k];
      weight += std::pow(a[c * kBases + j], 2);
      pull += std::pow(std::max(g[c], 0.0), 2);
    }
    weight = std::sqrt(weight), pull = std::sqrt(pull);
    if (weight > 0) {
      for (size_t c = 0; c < kChannels; ++c)
        if (a[c * kBases + j] > 0)
          violation = std::max(violation, std::abs(g[c] - lambda * a[c * kBases + j] / weight));
    } else {
      violation = std::max(0.0, pull - lambda);
    }
    EXPECT_LE(violation, 1e-4 * largest) << "function " << j;
  }
}

// Where the penalty goes to nothing the lasso's weights go to those of non-negative least squares.
TEST(GroupLasso, WithoutPenaltyIsNonNegativeLeastSquares) {
  const Problem problem = make_problem(6);
  std::vector<double> lasso(kChannels * kBases), plain;
  for (double lambda = 1; lambda > 1e-7; lambda *= 0.5)
    group_lasso(problem.gram.data(), kBases, problem.correlations.data(), lambda * problem.square, lasso);
  std::vector<int> all(kBases);
  std::iota(all.begin(), all.end(), 0);
  Elimination(problem.gram.data(), kBases).weights({problem.correlations.data(), problem.square}, all, plain);
  EXPECT_NEAR(half_error(problem, lasso), half_error(problem, plain), 1e-5 * problem.square);
}

// Both minimise the same sum: at the lambda of a point of the stagewise path, its value of that sum goes to the lasso's
// as the step goes to 0.
TEST(StagewiseLasso, GoesToTheLassoAsItsStepGoesToZero) {
  const Problem problem = make_problem(8);
  std::vector<double> gaps;
  for (const double step : {0.05, 0.01, 0.002}) {
    const std::vector<LassoPoint> path =
        stagewise_lasso(problem.gram.data(), kBases, problem.correlations.data(), step, 0.02);
    ASSERT_GT(path.size(), 3u);
    double worst = 0;
    for (const LassoPoint& point : path) {
      std::vector<double> a(kChannels * kBases);
      group_lasso(problem.gram.data(), kBases, problem.correlations.data(), point.lambda, a);
      const double best = half_error(problem, a) + point.lambda * penalty(a);
      worst = std::max(worst, (half_error(problem, point.a) + point.lambda * penalty(point.a)) / best - 1);
    }
    gaps.push_back(worst);
  }
  EXPECT_LT(gaps[1], gaps[0]);
  EXPECT_LT(gaps[2], gaps[1]);
  EXPECT_LT(gaps[2], 0.02);
}

TEST(LassoPaths, FindTheFunctionsOfASum) {
  const Problem problem = make_problem(12);
  for (const bool stagewise : {false, true}) {
    const SparsePath path = (stagewise ? stagewise_lasso_path : group_lasso_path)(
        problem.gram.data(), kBases, {problem.correlations.data(), problem.square}, 8);
    ASSERT_EQ(path.errors.size(), path.order.size() + 1);
    for (const int j : problem.support)
      EXPECT_NE(std::find(path.order.begin(), path.order.end(), static_cast<uint16_t>(j)), path.order.end());
    EXPECT_LT(path.errors.back(), 1e-6 * problem.square);
  }
}

}  // namespace
}  // namespace vamp::fit
