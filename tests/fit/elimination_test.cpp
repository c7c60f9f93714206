#include "engine/fit/elimination.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/fit/measurement.h"
#include "engine/fit/rows.h"
#include "tests/fit/synthetic.h"

namespace vamp::fit {
namespace {

// Given the dictionary, what a sum of its functions is made of is found again, from data in half floats.
TEST(Elimination, FindsTheFunctionsOfASum) {
  constexpr size_t kTexels = 48;
  for (const size_t functions : {3u, 5u}) {
    const test::Synthetic truth = test::random_synthetic(7 + static_cast<uint32_t>(functions), kTexels, 20, functions);
    const Btf btf = test::measure(truth, kTexels, 1);
    const Measurement measurement(btf);
    const size_t p = truth.dictionary.size(), pairs = measurement.pair_count();
    Rows columns(p, pairs);
    for (size_t j = 0; j < p; ++j)
      evaluate_column(truth.dictionary[j], measurement.pairs(), measurement.roots().data(), columns.row(j));
    std::vector<double> gram(p * p), correlations(kChannels * p), a;
    gram_rows(columns.row(0), p, pairs, gram.data());
    Elimination elimination(gram.data(), p);
    std::vector<float> row(measurement.values());
    size_t found = 0;
    double error = 0, square = 0;
    for (size_t t = 0; t < kTexels; ++t) {
      measurement.read(t, row.data());
      dot_rows(row.data(), kChannels, columns.row(0), p, pairs, correlations.data());
      TexelTarget target{correlations.data(), 0};
      dot_rows(row.data(), 1, row.data(), 1, row.size(), &target.square);
      const SparsePath path = elimination.path(target, functions);
      ASSERT_GE(path.order.size(), functions);
      const std::vector<int> support(path.order.begin(), path.order.begin() + static_cast<std::ptrdiff_t>(functions));
      for (const int j : support) {
        const auto& real = truth.texels[t].support;
        found += std::find(real.begin(), real.end(), j) != real.end() ? 1u : 0u;
      }
      elimination.weights(target, support, a);
      for (size_t c = 0; c < kChannels; ++c)
        for (const int j : support) {
          const float minus = -static_cast<float>(a[c * p + static_cast<size_t>(j)]);
          add_combinations(&minus, 1, columns.row(static_cast<size_t>(j)), 1, pairs, row.data() + c * pairs);
        }
      double left = 0;
      dot_rows(row.data(), 1, row.data(), 1, row.size(), &left);
      error += left;
      square += target.square;
    }
    EXPECT_GE(static_cast<double>(found), 0.99 * static_cast<double>(kTexels * functions));
    EXPECT_LE(std::sqrt(error / square), 3e-4);
  }
}

TEST(Elimination, ErrorsFallAlongThePathAndBelongToItsSupports) {
  const test::Synthetic truth = test::random_synthetic(3, 4, 12, 8);
  const Btf btf = test::measure(truth, 4, 1);
  const Measurement measurement(btf);
  const size_t p = 12, pairs = measurement.pair_count();
  Rows columns(p, pairs);
  for (size_t j = 0; j < p; ++j)
    evaluate_column(truth.dictionary[j], measurement.pairs(), measurement.roots().data(), columns.row(j));
  std::vector<double> gram(p * p), correlations(kChannels * p), a;
  gram_rows(columns.row(0), p, pairs, gram.data());
  std::vector<float> row(measurement.values());
  for (size_t t = 0; t < 4; ++t) {
    measurement.read(t, row.data());
    dot_rows(row.data(), kChannels, columns.row(0), p, pairs, correlations.data());
    TexelTarget target{correlations.data(), 0};
    dot_rows(row.data(), 1, row.data(), 1, row.size(), &target.square);
    Elimination elimination(gram.data(), p);
    const SparsePath path = elimination.path(target, 6);
    ASSERT_LE(path.order.size(), 6u);
    ASSERT_EQ(path.errors.size(), path.order.size() + 1);
    for (size_t m = 1; m < path.errors.size(); ++m) {
      EXPECT_LE(path.errors[m], path.errors[m - 1]);
      const std::vector<int> support(path.order.begin(), path.order.begin() + static_cast<std::ptrdiff_t>(m));
      EXPECT_NEAR(elimination.weights(target, support, a), double{path.errors[m]}, 1e-6 * target.square);
    }
  }
}

TEST(Elimination, ATexelOfZerosHasNoFunctions) {
  const std::vector<double> gram = {1, 0.5, 0.5, 1}, zeros(6);
  const SparsePath path = Elimination(gram.data(), 2).path({zeros.data(), 0}, 2);
  EXPECT_TRUE(path.order.empty());
  EXPECT_EQ(path.errors.size(), 1u);
}

}  // namespace
}  // namespace vamp::fit
