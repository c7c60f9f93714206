// The ray tests that GLSL and C++ share.
#include "shaders/shared/intersect.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "engine/accel/bvh_box.h"
#include "tests/accel/meshes.h"

namespace vamp {
namespace {

vec4 hit_triangle(vec3 origin, vec3 direction, vec3 v0, vec3 v1, vec3 v2, float t_min, float t_max) {
  return intersect_triangle(origin, direction, ray_side(direction), ray_above(direction), v0, v1, v2, t_min, t_max);
}

// In numbers.
vec2 span(const uvec4& box, const BoxRay& ray, float t_min, float t_max) {
  const ivec2 bits = box_span(box, ray, floatBitsToInt(t_min), floatBitsToInt(t_max));
  return vec2(glm::intBitsToFloat(bits.x), glm::intBitsToFloat(bits.y));
}

TEST(IntersectTriangle, GivesDistanceAndBarycentricsOfAKnownPoint) {
  const vec4 hit = hit_triangle({0.25f, 0.5f, 3}, {0, 0, -1}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0, 100);
  EXPECT_FLOAT_EQ(hit.w, 1);
  EXPECT_FLOAT_EQ(hit.x, 3);
  EXPECT_FLOAT_EQ(hit.y, 0.25f);
  EXPECT_FLOAT_EQ(hit.z, 0.5f);
}

TEST(IntersectTriangle, BothSidesAreHit) {
  EXPECT_EQ(hit_triangle({0.2f, 0.2f, -1}, {0, 0, 1}, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0, 100).w, 1);
  EXPECT_EQ(hit_triangle({0.2f, 0.2f, -1}, {0, 0, 1}, {0, 0, 0}, {0, 1, 0}, {1, 0, 0}, 0, 100).w, 1);
}

TEST(IntersectTriangle, ParallelRaysAndBareLinesAreMissesWithoutNaN) {
  for (const vec3 d : {vec3(1, 0, 0), vec3(0, 1, 0)}) {
    const vec4 hit = hit_triangle({0, 0, 0}, d, {0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 0, 100);
    EXPECT_EQ(hit.w, 0);
    EXPECT_FALSE(std::isnan(hit.x) || std::isnan(hit.y) || std::isnan(hit.z));
  }
  const vec4 point = hit_triangle({0, 0, 1}, {0, 0, -1}, {0, 0, 0}, {0, 0, 0}, {0, 0, 0}, 0, 100);
  EXPECT_EQ(point.w, 0);
}

TEST(IntersectTriangle, AnEdgeSharedByTwoTrianglesIsNeverMissedByBoth) {
  std::mt19937 random(3);
  for (int i = 0; i < 200000; ++i) {
    const vec3 a = random_point(random, vec3(-1), vec3(1));
    const vec3 b = random_point(random, vec3(-1), vec3(1));
    const vec3 side = random_direction(random);
    const vec3 p = a + (b - a) * (static_cast<float>(random() % 1000) / 1000.0f);
    const vec3 origin = p + glm::cross(b - a, side) * 3.0f;
    const vec3 direction = glm::normalize(p - origin);
    const vec4 left = hit_triangle(origin, direction, a, b, p + side, 0, 1e30f);
    const vec4 right = hit_triangle(origin, direction, b, a, p - side, 0, 1e30f);
    // At the two end points a ray may pass beside both.
    if (glm::length(p - a) < 1e-3f || glm::length(p - b) < 1e-3f) continue;
    if (glm::length(glm::cross(b - a, side)) < 1e-2f) continue;
    ASSERT_TRUE(left.w > 0 || right.w > 0) << i;
  }
}

TEST(BoxSpan, AxisParallelRaysInTheFaceOfABoxHit) {
  const uvec4 box = pack_box({uvec3(100), uvec3(200)}, 0);
  const vec3 scale(1e-3f);
  const vec3 grid(0);
  for (const float x : {0.1f, 0.15f, 0.2f}) {
    const vec3 origin(x, 0.15f, 1);
    const vec3 direction(0, 0, -1);
    const vec2 s = span(box, box_ray(origin, direction, grid, scale), 0, 10);
    if (x == 0.15f) {
      EXPECT_LE(s.x, s.y);
      EXPECT_NEAR(s.x, 0.8f, 1e-5f);
      EXPECT_NEAR(s.y, 0.9f, 1e-5f);
    }
    EXPECT_FALSE(std::isnan(s.x) || std::isnan(s.y));
  }
  const vec3 origin(0.3f, 0.15f, 1);
  const vec3 direction(0, 0, -1);
  const vec2 s = span(box, box_ray(origin, direction, grid, scale), 0, 10);
  EXPECT_GT(s.x, s.y);
}

}  // namespace
}  // namespace vamp
