#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "engine/acquire/goniometer.h"
#include "engine/acquire/structure.h"
#include "tests/acquire/shapes.h"

namespace vamp::acquire {
namespace {

class EveryStructure : public ::testing::TestWithParam<std::string> {
 protected:
  Mesostructure build() const {
    auto structure = make_structure(GetParam());
    EXPECT_TRUE(structure);
    return (*structure)->build(64);
  }
};

TEST_P(EveryStructure, IsFiniteAndInRange) {
  const Mesostructure built = build();
  EXPECT_GT(built.mm, 0);
  EXPECT_EQ(built.name, GetParam());
  ASSERT_GT(built.facets.size(), 1000u);
  for (const Facet& facet : built.facets) {
    ASSERT_LT(facet.matter, built.matters.size());
    for (int c = 0; c < 3; ++c) {
      ASSERT_TRUE(facet.colour[c] >= 0 && facet.colour[c] <= 1);
      ASSERT_TRUE(std::isfinite(facet.fibre[c]));
      for (const vec3& corner : facet.corner) ASSERT_TRUE(std::abs(corner[c]) < 8);
    }
  }
}

TEST_P(EveryStructure, IsTheSameEveryTime) {
  const Mesostructure a = build(), b = build();
  ASSERT_EQ(a.facets.size(), b.facets.size());
  for (size_t i = 0; i < a.facets.size(); ++i) {
    ASSERT_EQ(a.facets[i].corner, b.facets[i].corner);
    ASSERT_EQ(a.facets[i].colour, b.facets[i].colour);
  }
}

// No light is lost below, and none is made: what is sent back of a sky of radiance 1 is between 0 and 1.
TEST_P(EveryStructure, KeepsTheEnergyBalance) {
  const Goniometer goniometer(build(), {}, Shadows::traced, 1);
  for (const double theta : {0.0, 45.0, 75.0}) {
    Random random(5);
    double sum = 0;
    constexpr int kPaths = 3000;
    for (int i = 0; i < kPaths; ++i) {
      const vec3 left = goniometer.trace_sky({random.next(), random.next()}, test::towards(theta, 77), random);
      for (int c = 0; c < 3; ++c) ASSERT_TRUE(left[c] >= 0 && std::isfinite(left[c]));
      sum += static_cast<double>(std::max({left.x, left.y, left.z})) / kPaths;
    }
    EXPECT_GT(sum, 0.01) << theta;
    EXPECT_LT(sum, 1.0) << theta;
  }
}

TEST_P(EveryStructure, SettingsHaveNamesOfTheirOwnAndStartInRange) {
  auto structure = make_structure(GetParam());
  std::set<std::string_view> names;
  for (const Setting& setting : (*structure)->settings()) {
    EXPECT_TRUE(names.insert(setting.name).second) << setting.name;
    EXPECT_FALSE(setting.what.empty());
    if (float* const* number = std::get_if<float*>(&setting.value)) {
      EXPECT_GE(**number, setting.low) << setting.name;
      EXPECT_LE(**number, setting.high) << setting.name;
      for (const float end : {setting.low, setting.high}) {
        if (setting.name == "mm") continue;
        auto other = make_structure(GetParam());
        ASSERT_TRUE(set(**other, setting.name, end));
      }
    }
  }
  // What the edits need.
  EXPECT_TRUE(names.contains("relief"));
  EXPECT_TRUE(names.contains("coat"));
}

std::vector<std::string> names() {
  std::vector<std::string> result;
  for (const StructureRow& row : structures()) result.emplace_back(row.name);
  return result;
}
INSTANTIATE_TEST_SUITE_P(All, EveryStructure, ::testing::ValuesIn(names()), [](const auto& each) {
  std::string name = each.param;
  std::erase(name, '-');
  return name;
});

TEST(Structures, SettingsChangeWhatIsBuilt) {
  auto denim = make_structure("denim");
  ASSERT_TRUE(denim);
  ASSERT_TRUE(set(**denim, "warp", vec3(0.5f, 0, 0)));
  ASSERT_TRUE(set(**denim, "blend", 0));
  ASSERT_TRUE(set(**denim, "coat", 0));
  const Mesostructure built = (*denim)->build(48);
  EXPECT_EQ(built.matters[0].coat_colour, vec3(0));
  for (const Facet& facet : built.facets) EXPECT_EQ(facet.colour.y == 0, facet.colour.z == 0);
}

TEST(Structures, HalfTheReliefIsHalfTheHeight) {
  const auto height = [](float relief) {
    auto calf = make_structure("calf");
    EXPECT_TRUE(set(**calf, "relief", relief));
    const FacetGrid grid((*calf)->build(64).facets);
    return grid.top() - grid.bottom();
  };
  EXPECT_NEAR(height(0.5f), 0.5f * height(1), 1e-5f);
}

TEST(Structures, WrongNamesValuesAndKindsAreRefused) {
  const auto unknown = make_structure("crocodille");
  ASSERT_FALSE(unknown);
  EXPECT_EQ(unknown.error().kind, ErrorKind::usage);
  EXPECT_NE(unknown.error().expected.find("crocodile"), std::string::npos);
  auto denim = make_structure("denim");
  EXPECT_EQ(set(**denim, "colour", 1).error().kind, ErrorKind::usage);
  EXPECT_EQ(set(**denim, "coat", -1).error().kind, ErrorKind::usage);
  EXPECT_EQ(set(**denim, "coat", std::nanf("")).error().kind, ErrorKind::usage);
  EXPECT_EQ(set(**denim, "coat", vec3(1)).error().kind, ErrorKind::usage);
  EXPECT_EQ(set(**denim, "warp", 0.5f).error().kind, ErrorKind::usage);
  EXPECT_EQ(set(**denim, "warp", vec3(0, 2, 0)).error().kind, ErrorKind::usage);
}

}  // namespace
}  // namespace vamp::acquire
