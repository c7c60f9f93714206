#include "engine/fit/nnls.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <random>

namespace vamp::fit {
namespace {

// X of n rows and p columns with values in [0, 1): correlated, as the columns of lobes are.
struct Problem {
  size_t n = 0, p = 0;
  std::vector<double> x, y, gram, target;
};

Problem random_problem(uint32_t seed, size_t n, size_t p) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(0, 1);
  Problem problem{
      n, p, std::vector<double>(n * p), std::vector<double>(n), std::vector<double>(p * p), std::vector<double>(p)};
  for (double& value : problem.x) value = uniform(random);
  for (double& value : problem.y) value = uniform(random) * 2 - 0.5;
  for (size_t i = 0; i < n; ++i)
    for (size_t a = 0; a < p; ++a) {
      problem.target[a] += problem.x[i * p + a] * problem.y[i];
      for (size_t b = 0; b < p; ++b) problem.gram[a * p + b] += problem.x[i * p + a] * problem.x[i * p + b];
    }
  return problem;
}

std::vector<int> all(size_t p) {
  std::vector<int> columns(p);
  std::iota(columns.begin(), columns.end(), 0);
  return columns;
}

double error_at(const Problem& problem, const std::vector<double>& a) {
  double error = 0;
  for (size_t i = 0; i < problem.n; ++i) {
    double rest = problem.y[i];
    for (size_t j = 0; j < problem.p; ++j) rest -= problem.x[i * problem.p + j] * a[j];
    error += rest * rest;
  }
  return error;
}

TEST(Nnls, MeetsTheKarushKuhnTuckerConditions) {
  for (uint32_t seed = 1; seed <= 50; ++seed) {
    const Problem problem = random_problem(seed, 40, 4 + seed % 20);
    std::vector<double> a(problem.p);
    Nnls nnls(problem.gram.data(), problem.p);
    nnls.solve(all(problem.p), problem.target.data(), a.data());
    for (size_t j = 0; j < problem.p; ++j) {
      double gradient = problem.target[j];
      for (size_t k = 0; k < problem.p; ++k) gradient -= problem.gram[j * problem.p + k] * a[k];
      EXPECT_GE(a[j], 0);
      if (a[j] > 0) {
        EXPECT_NEAR(gradient, 0, 1e-6) << "seed " << seed << ", column " << j;
      } else {
        EXPECT_LE(gradient, 1e-6) << "seed " << seed << ", column " << j;
      }
    }
  }
}

// At the solution a'Ga = a'c, so that the error needs nothing but correlations.
TEST(Nnls, GramSpaceErrorsAreThoseOfTheData) {
  const Problem problem = random_problem(7, 60, 12);
  std::vector<double> a(problem.p);
  Nnls nnls(problem.gram.data(), problem.p);
  nnls.solve(all(problem.p), problem.target.data(), a.data());
  double square = 0;
  for (const double value : problem.y) square += value * value;
  double error = square;
  for (const int j : nnls.passive()) error -= a[static_cast<size_t>(j)] * problem.target[static_cast<size_t>(j)];
  EXPECT_NEAR(error, error_at(problem, a), 1e-7 * square);
}

TEST(Nnls, EqualAndEmptyColumnsDoNoHarm) {
  Problem problem = random_problem(9, 30, 5);
  for (size_t i = 0; i < 5; ++i) {
    problem.gram[4 * 5 + i] = problem.gram[3 * 5 + i];
    problem.gram[i * 5 + 4] = problem.gram[i * 5 + 3];
    problem.gram[0 * 5 + i] = problem.gram[i * 5 + 0] = 0;
  }
  problem.gram[4 * 5 + 4] = problem.gram[3 * 5 + 3];
  problem.target[4] = problem.target[3];
  problem.target[0] = 0;
  std::vector<double> a(5);
  Nnls nnls(problem.gram.data(), 5);
  nnls.solve(all(5), problem.target.data(), a.data());
  for (const double value : a) EXPECT_TRUE(std::isfinite(value) && value >= 0);
  EXPECT_EQ(a[0], 0);
}

// What a column's removal costs while the others keep their signs.
TEST(Nnls, EliminationCostsAreTrue) {
  const Problem problem = random_problem(21, 80, 6);
  std::vector<double> a(problem.p), without(problem.p), costs;
  Nnls nnls(problem.gram.data(), problem.p);
  nnls.solve(all(problem.p), problem.target.data(), a.data());
  const std::vector<int> passive(nnls.passive().begin(), nnls.passive().end());
  nnls.elimination_costs(costs);
  ASSERT_GE(passive.size(), 2u);
  Nnls other(problem.gram.data(), problem.p);
  for (size_t i = 0; i < passive.size(); ++i) {
    std::vector<int> rest = passive;
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(i));
    without.assign(problem.p, 0);
    other.solve(rest, problem.target.data(), without.data());
    const auto j = static_cast<size_t>(passive[i]);
    const double predicted = a[j] * a[j] * costs[i];
    if (other.passive().size() == rest.size()) {
      EXPECT_NEAR(error_at(problem, without) - error_at(problem, a), predicted, 1e-6 * predicted + 1e-9);
    } else {
      EXPECT_GE(error_at(problem, without) - error_at(problem, a), predicted * (1 - 1e-6));
    }
  }
}

}  // namespace
}  // namespace vamp::fit
