#include "engine/fit/columns.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/brdf/registry.h"
#include "engine/material/directions.h"
#include "engine/material/tables.h"
#include "tests/fit/synthetic.h"

namespace vamp::fit {
namespace {

// The oracle of the kernels sees the same function as a material of one texel.
std::vector<double> by_the_oracle(const Basis& basis, const Pairs& pairs) {
  Spmm spmm;
  spmm.width = spmm.height = 1;
  spmm.dictionary = {basis};
  spmm.clusters = {{"all"}};
  constexpr uint32_t kOne = 0x3c00;  // half
  spmm.texels = {{0, 1u << 8, 0, 0}};
  spmm.entries = {{kOne << 16, kOne | kOne << 16}};
  const EditedTables rows = edited_tables(spmm, {});
  std::vector<double> values;
  for (const vec3& view : pairs.views)
    for (const vec3& light : pairs.lights)
      values.push_back(evaluate(spmm, rows, 0, {}, 0, 0, dvec3(light), dvec3(view)).x);
  return values;
}

TEST(Columns, HoldWhatTheOracleSays) {
  const Pairs pairs = {ubo2003_directions(), ubo2003_directions()};
  std::mt19937 random(11);
  std::vector<Basis> bases = test::random_dictionary(random, 21);
  Basis rare;  // a variant that fits do not make, but editors do
  rare.lobe = default_lobe(Model::oren_nayar, kOrenNayarFull);
  rare.normal = vec3(0.28f, 0, 0.96f);
  bases.push_back(rare);
  std::vector<float> column(pairs.count());
  for (const Basis& basis : bases) {
    evaluate_column(basis, pairs, nullptr, column.data());
    const std::vector<double> oracle = by_the_oracle(basis, pairs);
    double largest = 0;
    for (const double value : oracle) largest = std::max(largest, std::abs(value));
    for (size_t i = 0; i < oracle.size(); ++i)
      ASSERT_NEAR(column[i], oracle[i], 2e-5 * largest) << model_row(basis.lobe.model).name << ", pair " << i;
  }
}

TEST(Columns, AreMultipliedByTheirFactors) {
  const Pairs pairs = {ubo2003_directions(), ubo2003_directions()};
  std::vector<float> factor(pairs.count()), plain(pairs.count()), scaled(pairs.count());
  for (size_t i = 0; i < factor.size(); ++i) factor[i] = static_cast<float>(i % 7);
  const Basis basis{"", default_lobe(Model::ward), {0, 0, 1}, 0};
  evaluate_column(basis, pairs, nullptr, plain.data());
  evaluate_column(basis, pairs, factor.data(), scaled.data());
  for (size_t i = 0; i < plain.size(); ++i) ASSERT_EQ(scaled[i], plain[i] * factor[i]);
}

}  // namespace
}  // namespace vamp::fit
