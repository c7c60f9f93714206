#include "engine/scene/placement.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

namespace vamp {
namespace {

constexpr float kQuarter = 1.57079632679f;

void expect_near(const vec3& a, const vec3& b) {
  EXPECT_LT(glm::length(a - b), 1e-6f) << a.x << " " << a.y << " " << a.z;
}

TEST(Placement, AtRestLeavesEveryPointAsItIs) {
  std::mt19937 random(1);
  std::uniform_real_distribution<float> any(-1e6f, 1e6f);
  const RigidMotion motion({}, vec3(0.1f, 1e5f, -7));
  for (int i = 0; i < 1000; ++i) {
    const vec3 p(any(random), any(random) * 1e-9f, any(random));
    EXPECT_EQ(motion.point(p), p);
    EXPECT_EQ(motion.direction(p), p);
  }
}

TEST(Placement, TurnsAboutTheAxesOneAfterAnother) {
  const vec3 pivot(1, 2, 3);
  expect_near(RigidMotion({{}, {kQuarter, 0, 0}}, pivot).direction({0, 1, 0}), {0, 0, 1});
  expect_near(RigidMotion({{}, {0, kQuarter, 0}}, pivot).direction({0, 0, 1}), {1, 0, 0});
  expect_near(RigidMotion({{}, {0, 0, kQuarter}}, pivot).direction({1, 0, 0}), {0, 1, 0});
  // About X first, then about Y: up becomes forward, and that becomes right.
  expect_near(RigidMotion({{}, {kQuarter, kQuarter, 0}}, pivot).direction({0, 1, 0}), {1, 0, 0});
  // The pivot goes with the offset alone.
  expect_near(RigidMotion({{5, 0, 0}, {1, 2, 3}}, pivot).point(pivot), {6, 2, 3});
  expect_near(RigidMotion({{0, 0, 1}, {0, 0, kQuarter}}, pivot).point({2, 2, 3}), {1, 3, 4});
}

TEST(Placement, KeepsLengthsAndHandedness) {
  const RigidMotion motion({{0.3f, 0, 9}, {0.4f, -2.2f, 17}}, vec3(3));
  const vec3 x = motion.direction({1, 0, 0}), y = motion.direction({0, 1, 0}), z = motion.direction({0, 0, 1});
  for (const vec3& axis : {x, y, z}) EXPECT_NEAR(glm::length(axis), 1, 1e-6f);
  expect_near(glm::cross(x, y), z);
  EXPECT_NEAR(glm::length(motion.point({1, 2, 3}) - motion.point({4, -2, 3})), 5, 1e-5f);
}

TEST(Placement, TheBoxAroundHoldsWhatStoodInTheBox) {
  Bounds box;
  box.extend(vec3(-1, 0, 2));
  box.extend(vec3(1, 3, 2.5f));
  EXPECT_EQ(RigidMotion({{1, 0, 0}, {}}, vec3(0)).around(box), (Bounds{vec3(0, 0, 2), vec3(2, 3, 2.5f)}));
  EXPECT_TRUE(RigidMotion({{1, 0, 0}, {1, 1, 1}}, vec3(0)).around({}).empty());
  std::mt19937 random(2);
  std::uniform_real_distribution<float> unit(0, 1);
  const RigidMotion motion({{1, 2, 3}, {0.5f, 1, -2}}, box.center());
  const Bounds around = motion.around(box);
  for (int i = 0; i < 1000; ++i) {
    const vec3 p = motion.point(box.lo + box.size() * vec3(unit(random), unit(random), unit(random)));
    for (int k = 0; k < 3; ++k) {
      EXPECT_GE(p[k], around.lo[k] - 1e-6f);
      EXPECT_LE(p[k], around.hi[k] + 1e-6f);
    }
  }
}

}  // namespace
}  // namespace vamp
