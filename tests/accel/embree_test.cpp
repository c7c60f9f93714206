// Embree, an independent ray tracer, must see the same first hits.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "bench/embree_scene.h"
#include "engine/accel/bvh.h"
#include "tests/accel/meshes.h"

namespace vamp {
namespace {

// Rays from everywhere around and inside. At most 1 in 10,000 may differ (rays along edges); distances to 1e-4 of it.
void expect_agreement(const TestMesh& mesh, float reach, uint32_t seed) {
  constexpr int kRays = 100000;
  const Bvh bvh = build_bvh(mesh.positions, mesh.triangles);
  const EmbreeScene embree(mesh.positions, mesh.triangles, EmbreeScene::Edges::watertight);
  std::mt19937 random(seed);
  int hits = 0;
  int different = 0;
  for (int i = 0; i < kRays; ++i) {
    const vec3 origin = random_point(random, vec3(-reach), vec3(reach));
    const vec3 target = random_point(random, vec3(-reach * 0.4f), vec3(reach * 0.4f));
    const vec3 direction = i % 3 == 0 ? random_direction(random) : glm::normalize(target - origin);
    RTCRayHit expected = EmbreeScene::ray_hit(origin, direction);
    embree.intersect(expected);
    const std::optional<Hit> found = pick(bvh, origin, direction);
    const bool expected_hit = expected.hit.geomID != RTC_INVALID_GEOMETRY_ID;
    if (expected_hit) ++hits;
    if (expected_hit != found.has_value()) {
      ++different;
    } else if (found) {
      const bool near = std::abs(found->t - expected.ray.tfar) <= 1e-4f * std::max(expected.ray.tfar, 1e-2f * reach);
      if (!near) ++different;
      if (near && found->triangle == expected.hit.primID) {
        const float slack = 2e-3f;
        EXPECT_NEAR(found->u, expected.hit.u, slack);
        EXPECT_NEAR(found->v, expected.hit.v, slack);
      }
    }
    EXPECT_EQ(found.has_value(), occluded(bvh, origin, direction, 0, 3.4e38f));
  }
  EXPECT_GT(hits, kRays / 10);
  EXPECT_LE(different, kRays / 10000);
}

TEST(Embree, AgreesOnBumpySpheresOverAFloor) {
  TestMesh mesh;
  mesh.add_sphere(vec3(0, 0, 0), 1.0f, 60, 0.08f);
  mesh.add_sphere(vec3(1.5f, 0.2f, -0.4f), 0.5f, 40, 0.15f);
  mesh.add_grid(vec3(-3, -1.1f, -3), vec3(0, 0, 6), vec3(6, 0, 0), 4, 4);
  expect_agreement(mesh, 3.0f, 1);
}

TEST(Embree, AgreesOnASoupOfRandomTriangles) {
  TestMesh mesh;
  std::mt19937 random(2);
  for (int i = 0; i < 20000; ++i) {
    const vec3 p = random_point(random, vec3(-1), vec3(1));
    const float size = 0.01f + 0.1f * static_cast<float>(random() % 100) / 100.0f;
    mesh.add(p, p + random_direction(random) * size, p + random_direction(random) * size);
  }
  expect_agreement(mesh, 2.0f, 3);
}

TEST(Embree, AgreesOnLongThinFoldsWithLargeTriangles) {
  TestMesh mesh;
  for (int i = 0; i < 60; ++i) {
    const float x = static_cast<float>(i) * 0.5f - 15.0f;
    mesh.add_grid(vec3(x, -10, -10), vec3(0.4f, 0, 0.3f), vec3(0, 20, 0), 1, 200);
    mesh.add_grid(vec3(x, -10, 0), vec3(0, 0, 12), vec3(0, 20, 3), 3, 1);
  }
  expect_agreement(mesh, 20.0f, 4);
}

}  // namespace
}  // namespace vamp
