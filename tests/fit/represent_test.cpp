// What is compared with measurements is what the renderer shows, edits and all.
#include "engine/fit/represent.h"

#include <gtest/gtest.h>

#include "tests/material/small_spmm.h"

namespace vamp::fit {
namespace {

TEST(SpmmValues, AreTheOraclesAfterEdits) {
  const Spmm spmm = test::small_spmm();
  EditLayer edits;
  BasisEdit dyed, turned, silent;
  dyed.gain = {2, 0.5f, 0};
  turned.normal = test::tilted(20, 130);
  turned.lobe = Lobe{Model::ward, 0, {1, 0.3f, 0.5f}};
  silent.mute = true;
  edits.set({0, 1}, dyed);
  edits.set({1, 2}, turned);
  edits.set({2, 0}, silent);
  edits.residual_strength = 0.7f;
  edits.residual_terms = 1;
  Pairs pairs;
  std::mt19937 random(5);
  for (int i = 0; i < 4; ++i) {
    pairs.views.push_back(vec3(test::random_direction(random)));
    pairs.lights.push_back(spmm.residual.directions[static_cast<size_t>(3 * i + 1)]);
  }
  const DirectionTables directions = triangulate(spmm.residual.directions, "").value();
  const EditedTables edited = edited_tables(spmm, edits);
  const auto values = SpmmValues::make(spmm, pairs, edits);
  ASSERT_TRUE(values);
  EXPECT_EQ(values->terms(), 1);
  std::vector<float> row(3 * pairs.count());
  for (size_t texel = 0; texel < spmm.texels.size(); ++texel) {
    values->functions(texel, row.data());
    for (int k = 0; k <= values->terms(); ++k) values->add_residual(texel, k, row.data());
    for (size_t p = 0; p < pairs.count(); ++p) {
      const dvec3 expected =
          evaluate(spmm, edited, edits.residual_terms, directions, static_cast<int>(texel) % spmm.width,
                   static_cast<int>(texel) / spmm.width, dvec3(pairs.lights[p % 4]), dvec3(pairs.views[p / 4]));
      for (size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(row[c * pairs.count() + p], expected[static_cast<int>(c)],
                    1e-3 * (1 + std::abs(expected[static_cast<int>(c)])));
    }
  }
}

}  // namespace
}  // namespace vamp::fit
