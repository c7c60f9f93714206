// The spatial reflectance field as a material, and the steps that stored numbers are rounded to.
#include "engine/fit/srf.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "engine/fit/bake.h"

namespace vamp::fit {
namespace {

// Grey texels whose light grows with a vector of their own times the half vector.
Btf grey_field(uint32_t side) {
  BtfInfo info;
  info.width = info.height = side;
  info.views = info.lights = ubo81();
  info.name = "field";
  Btf btf = Btf::in_memory(info).value();
  std::mt19937 random(3);
  std::uniform_real_distribution<double> uniform(-0.2, 0.2);
  std::vector<float> values(btf.values_per_texel());
  for (size_t t = 0; t < btf.texel_count(); ++t) {
    const dvec3 s(uniform(random), uniform(random), 0.6 + uniform(random));
    size_t at = 0;
    for (const dvec3& view : info.views.directions)
      for (const dvec3& light : info.lights.directions) {
        const dvec3 sum = view + light;
        const double length = std::sqrt(sum.x * sum.x + sum.y * sum.y + sum.z * sum.z);
        const double value = 0.2 * light.z + (s.x * sum.x + s.y * sum.y + s.z * sum.z) / length;
        for (int c = 0; c < 3; ++c) values[at++] = static_cast<float>(std::max(value, 0.0));
      }
    btf.write_texel(t, values);
  }
  return btf;
}

TEST(Srf, IsStoredExactlyWhereItsVectorsNeedNoMoreThanFourNumbers) {
  const Btf btf = grey_field(8);
  for (const int clusters : {1, 3}) {
    const auto result = fit_srf(btf, {.clusters = clusters});
    ASSERT_TRUE(result) << result.error().message();
    EXPECT_LT(result->report.exact_error, 0.05);
    EXPECT_NEAR(result->report.stored_error, result->report.exact_error, 1e-3);
    EXPECT_EQ(result->spmm.clusters.size(), static_cast<size_t>(clusters));
    EXPECT_EQ(result->spmm.entries.size(), 64u);
  }
}

TEST(Srf, IsTheSameForASeedWhateverTheNumberOfThreads) {
  const Btf btf = grey_field(6);
  const auto one = fit_srf(btf, {.threads = 1}), three = fit_srf(btf, {.threads = 3});
  ASSERT_TRUE(one && three);
  EXPECT_EQ(one->spmm.texels.size(), three->spmm.texels.size());
  for (size_t i = 0; i < one->spmm.residual.records.size(); ++i)
    for (int k = 0; k < 8; ++k)
      ASSERT_EQ(one->spmm.residual.records[i].halves[k], three->spmm.residual.records[i].halves[k]);
}

TEST(Steps, ArePowersOfTwoBelowTheirLimit) {
  EXPECT_EQ(Step::at_most(0.3).size, 0.25f);
  EXPECT_EQ(Step::at_most(0.25).size, 0.25f);
  EXPECT_EQ(Step::at_most(5).size, 4.f);
  EXPECT_EQ(Step::at_most(0).size, 0.f);
  EXPECT_EQ(stored(0.7f, {0.25f}), 0.75f);
  EXPECT_NEAR(stored(0.7f, {}), 0.7f, 5e-4f);
}

}  // namespace
}  // namespace vamp::fit
