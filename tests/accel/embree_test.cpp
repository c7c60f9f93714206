// Embree, an independent ray tracer, must see the same first hits.
#include <embree3/rtcore.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>

#include "engine/accel/bvh.h"
#include "tests/accel/meshes.h"

namespace vamp {
namespace {

class Embree {
 public:
  explicit Embree(const TestMesh& mesh) : device_(rtcNewDevice("threads=1")), scene_(rtcNewScene(device_)) {
    rtcSetSceneFlags(scene_, RTC_SCENE_FLAG_ROBUST);
    RTCGeometry geometry = rtcNewGeometry(device_, RTC_GEOMETRY_TYPE_TRIANGLE);
    void* vertices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(vec3),
                                             mesh.positions.size());
    std::memcpy(vertices, mesh.positions.data(), mesh.positions.size() * sizeof(vec3));
    void* indices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3, sizeof(uvec3),
                                            mesh.triangles.size());
    std::memcpy(indices, mesh.triangles.data(), mesh.triangles.size() * sizeof(uvec3));
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(scene_, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(scene_);
  }
  Embree(const Embree&) = delete;
  Embree& operator=(const Embree&) = delete;
  ~Embree() {
    rtcReleaseScene(scene_);
    rtcReleaseDevice(device_);
  }

  RTCRayHit trace(const vec3& origin, const vec3& direction) const {
    RTCRayHit ray{};
    ray.ray.org_x = origin.x;
    ray.ray.org_y = origin.y;
    ray.ray.org_z = origin.z;
    ray.ray.dir_x = direction.x;
    ray.ray.dir_y = direction.y;
    ray.ray.dir_z = direction.z;
    ray.ray.tfar = 3.4e38f;
    ray.ray.mask = ~0u;
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene_, &context, &ray);
    return ray;
  }

 private:
  RTCDevice device_;
  RTCScene scene_;
};

// Rays from everywhere around and inside. At most 1 in 10,000 may differ (rays along edges); distances to 1e-4 of it.
void expect_agreement(const TestMesh& mesh, float reach, uint32_t seed) {
  constexpr int kRays = 100000;
  const Bvh bvh = build_bvh(mesh.positions, mesh.triangles);
  const Embree embree(mesh);
  std::mt19937 random(seed);
  int hits = 0;
  int different = 0;
  for (int i = 0; i < kRays; ++i) {
    const vec3 origin = random_point(random, vec3(-reach), vec3(reach));
    const vec3 target = random_point(random, vec3(-reach * 0.4f), vec3(reach * 0.4f));
    const vec3 direction = i % 3 == 0 ? random_direction(random) : glm::normalize(target - origin);
    const RTCRayHit expected = embree.trace(origin, direction);
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
