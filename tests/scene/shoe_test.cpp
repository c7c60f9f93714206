// Real shoes from the test data, where it is there: VAMP_TEST_DATA names its folder.
#include <gtest/gtest.h>

#include <cstdlib>
#include <glm/geometric.hpp>

#include "engine/scene/scene.h"

namespace vamp {
namespace {

void expect_sound(const Scene& s) {
  EXPECT_GT(s.triangles.size(), 1000u);
  for (size_t i = 0; i < s.positions.size(); ++i) {
    ASSERT_NEAR(glm::length(s.normals[i]), 1, 1e-4f);
    ASSERT_NEAR(glm::length(vec3(s.tangents[i])), 1, 1e-4f);
    ASSERT_NEAR(glm::dot(vec3(s.tangents[i]), s.normals[i]), 0, 1e-3f);
    ASSERT_EQ(std::abs(s.tangents[i].w), 1);
  }
  for (const Part& part : s.parts) {
    EXPECT_GT(part.triangle_count, 0u);
    EXPECT_GT(part.mm_per_uv, 0);
  }
}

TEST(Shoe, OfEightMaterialsLoads) {
  const char* data = std::getenv("VAMP_TEST_DATA");
  if (data == nullptr) GTEST_SKIP() << "VAMP_TEST_DATA is not set";
  const auto s = load_scene(std::filesystem::path(data) / "shoe/shoe.gltf");
  ASSERT_TRUE(s) << s.error().message();
  EXPECT_EQ((*s)->parts.size(), 8u);
  EXPECT_GE((*s)->find_part("laces"), 0);
  expect_sound(**s);
}

TEST(Shoe, WithVariantsLoadsItsDefaultOne) {
  const char* data = std::getenv("VAMP_TEST_DATA");
  if (data == nullptr) GTEST_SKIP() << "VAMP_TEST_DATA is not set";
  const auto s = load_scene(std::filesystem::path(data) / "shoe-variants/MaterialsVariantsShoe.gltf");
  ASSERT_TRUE(s) << s.error().message();
  EXPECT_EQ((*s)->parts.size(), 1u);
  EXPECT_FALSE((*s)->notes.empty());
  expect_sound(**s);
}

}  // namespace
}  // namespace vamp
