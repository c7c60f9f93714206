#include "engine/fit/rows.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "engine/core/half.h"

namespace vamp::fit {
namespace {

Rows random_rows(uint32_t seed, size_t count, size_t length) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<float> uniform(-1, 1);
  Rows rows(count, length);
  for (float& value : rows.data) value = uniform(random);
  return rows;
}

double plain_dot(const float* a, const float* b, size_t n) {
  double sum = 0;
  for (size_t i = 0; i < n; ++i) sum += double{a[i]} * double{b[i]};
  return sum;
}

// Lengths and counts that leave rests behind every block.
TEST(Rows, DotProductsAreThoseOfDoubleArithmetic) {
  for (const size_t length : {1u, 7u, 513u, 6561u}) {
    const Rows a = random_rows(1, 6, length), b = random_rows(2, 5, length);
    std::vector<double> products(30);
    dot_rows(a.row(0), 6, b.row(0), 5, length, products.data());
    for (size_t i = 0; i < 6; ++i)
      for (size_t j = 0; j < 5; ++j)
        EXPECT_NEAR(products[i * 5 + j], plain_dot(a.row(i), b.row(j), length), 2e-6 * static_cast<double>(length));
  }
}

TEST(Rows, GramMatricesAreSymmetricAndThoseOfTheirRows) {
  const Rows a = random_rows(3, 37, 700);
  std::vector<double> gram(37 * 37);
  gram_rows(a.row(0), 37, 700, gram.data());
  for (size_t i = 0; i < 37; ++i)
    for (size_t j = 0; j < 37; ++j) {
      EXPECT_EQ(gram[i * 37 + j], gram[j * 37 + i]);
      EXPECT_NEAR(gram[i * 37 + j], plain_dot(a.row(i), a.row(j), 700), 1e-4);
    }
}

TEST(Rows, CombinationsAddUp) {
  const Rows x = random_rows(4, 9, 1003), factors = random_rows(5, 6, 9);
  Rows out = random_rows(6, 6, 1003);
  const Rows before = out;
  add_combinations(factors.row(0), 6, x.row(0), 9, 1003, out.row(0));
  for (size_t r = 0; r < 6; ++r)
    for (size_t k = 0; k < 1003; ++k) {
      double sum = double{before.row(r)[k]};
      for (size_t j = 0; j < 9; ++j) sum += double{factors.row(r)[j]} * double{x.row(j)[k]};
      ASSERT_NEAR(out.row(r)[k], sum, 1e-5);
    }
}

TEST(Rows, HalvesBecomeTheFloatsThatTheyAre) {
  std::vector<uint16_t> halves;
  for (uint32_t bits = 0; bits < 0x10000u; ++bits)
    if ((bits & 0x7c00u) != 0x7c00u) halves.push_back(static_cast<uint16_t>(bits));
  const std::vector<float> ones(halves.size(), 1.f);
  std::vector<float> floats(halves.size());
  floats_from_halves(halves.data(), 1, halves.size(), ones.data(), floats.data());
  for (size_t i = 0; i < halves.size(); ++i) ASSERT_EQ(floats[i], float_from_half(halves[i])) << halves[i];
}

TEST(Rows, HalvesThatAreNoNumbersBecomeFiniteOnes) {
  const std::vector<uint16_t> halves = {0x7c00, 0xfc00, 0x7e00, 0xffff};
  const std::vector<float> ones(4, 1.f);
  std::vector<float> floats(4);
  floats_from_halves(halves.data(), 1, 4, ones.data(), floats.data());
  for (const float value : floats) EXPECT_TRUE(std::isfinite(value));
}

}  // namespace
}  // namespace vamp::fit
