// Normals, UVs and tangents that are made up for a mesh.
#include "engine/scene/mesh.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "tests/scene/glb_builder.h"

namespace vamp {
namespace {

Mesh mesh_of(const test::Shape& s) {
  Mesh m;
  m.positions = s.positions;
  m.normals = s.normals;
  m.uvs = s.uvs;
  for (size_t i = 0; i + 2 < s.indices.size(); i += 3)
    m.triangles.emplace_back(s.indices[i], s.indices[i + 1], s.indices[i + 2]);
  return m;
}

TEST(Tangents, OnAPlanePointAlongUWithTheBitangentAgainstV) {
  Mesh m = mesh_of(test::plane(2, 3, 4));
  make_tangents(m);
  EXPECT_EQ(m.positions.size(), 25u);
  for (const vec4& t : m.tangents) {
    EXPECT_NEAR(t.x, 1, 1e-6f);
    EXPECT_EQ(t.w, 1);
  }
}

TEST(Tangents, MirroredUvsFlipTheBitangent) {
  test::Shape s = test::plane(2, 2);
  for (vec2& uv : s.uvs) uv.x = 1 - uv.x;
  Mesh m = mesh_of(s);
  make_tangents(m);
  for (const vec4& t : m.tangents) {
    EXPECT_NEAR(t.x, -1, 1e-6f);
    EXPECT_EQ(t.w, -1);
    const vec3 bitangent = glm::cross(vec3(0, 1, 0), vec3(t)) * t.w;
    EXPECT_NEAR(bitangent.z, -1, 1e-6f);  // v grows with z
  }
}

TEST(Tangents, VerticesOnAMirrorLineAreSplit) {
  // Two squares that share the edge x = 0, u = |x|.
  test::Shape s = test::plane(2, 1, 2);
  for (size_t i = 0; i < s.uvs.size(); ++i) s.uvs[i].x = std::abs(s.positions[i].x);
  Mesh m = mesh_of(s);
  make_tangents(m);
  EXPECT_EQ(m.positions.size(), 9u + 3u);
  ASSERT_EQ(m.tangents.size(), m.positions.size());
  for (const uvec3& t : m.triangles) {
    const float x = m.positions[t.x].x + m.positions[t.y].x + m.positions[t.z].x;
    for (int k = 0; k < 3; ++k) {
      EXPECT_NEAR(m.tangents[t[k]].x, x > 0 ? 1 : -1, 1e-6f);
      EXPECT_EQ(m.tangents[t[k]].w, x > 0 ? 1 : -1);
    }
  }
}

TEST(Tangents, OnASphereFollowTheParallels) {
  Mesh m = mesh_of(test::sphere(2, 32));
  make_tangents(m);
  for (const uvec3& t : m.triangles)
    for (int k = 0; k < 3; ++k) {
      const vec3 n = m.normals[t[k]];
      const vec3 tangent(m.tangents[t[k]]);
      EXPECT_NEAR(glm::length(tangent), 1, 1e-5f);
      EXPECT_NEAR(glm::dot(tangent, n), 0, 1e-5f);
      if (std::abs(n.y) > 0.95f) continue;
      const vec3 east = glm::normalize(vec3(n.z, 0, -n.x));
      EXPECT_GT(glm::dot(tangent, east), 0.99f);
      EXPECT_EQ(m.tangents[t[k]].w, 1);
    }
}

TEST(Tangents, DoNotDependOnHowVerticesAreShared) {
  const Mesh shared = mesh_of(test::sphere(1, 12));
  Mesh apart;
  for (const uvec3& t : shared.triangles) {
    const auto n = static_cast<uint32_t>(apart.positions.size());
    for (int k = 0; k < 3; ++k) {
      apart.positions.push_back(shared.positions[t[k]]);
      apart.normals.push_back(shared.normals[t[k]]);
      apart.uvs.push_back(shared.uvs[t[k]]);
    }
    apart.triangles.emplace_back(n, n + 1, n + 2);
  }
  Mesh a = shared;
  make_tangents(a);
  make_tangents(apart);
  for (size_t i = 0; i < a.triangles.size(); ++i)
    for (int k = 0; k < 3; ++k) EXPECT_EQ(a.tangents[a.triangles[i][k]], apart.tangents[apart.triangles[i][k]]);
}

TEST(Tangents, WithoutUvAreaAreStillAcrossTheNormal) {
  test::Shape s = test::box(vec3(1));
  for (vec2& uv : s.uvs) uv = vec2(0.5f);
  Mesh m = mesh_of(s);
  make_tangents(m);
  for (size_t i = 0; i < m.positions.size(); ++i) {
    EXPECT_NEAR(glm::length(vec3(m.tangents[i])), 1, 1e-6f);
    EXPECT_NEAR(glm::dot(vec3(m.tangents[i]), m.normals[i]), 0, 1e-6f);
  }
}

TEST(BoxProjection, ShowsTexturesUprightFromAllSides) {
  Mesh m = mesh_of(test::box(vec3(0.3f)));
  project_uvs(m, 1000);
  make_tangents(m);
  EXPECT_EQ(m.positions.size(), 24u);
  for (size_t i = 0; i < m.positions.size(); ++i) {
    EXPECT_EQ(m.tangents[i].w, 1);
    const vec3 up = glm::cross(m.normals[i], vec3(m.tangents[i]));
    if (std::abs(m.normals[i].y) < 0.5f) {
      EXPECT_NEAR(up.y, 1, 1e-6f);
    }
  }
}

TEST(BoxProjection, SplitsVerticesWhereTheSideChanges) {
  Mesh m = mesh_of(test::sphere(1, 16));
  const size_t before = m.positions.size();
  project_uvs(m, 1000);
  EXPECT_GT(m.positions.size(), before);
  ASSERT_EQ(m.uvs.size(), m.positions.size());
  ASSERT_EQ(m.normals.size(), m.positions.size());
  // No triangle's UVs are torn: a step of 1 in the plane is 10 in UV, in 3D it is never less.
  for (const uvec3& t : m.triangles)
    EXPECT_LE(glm::length(m.uvs[t.y] - m.uvs[t.x]), 10 * glm::length(m.positions[t.y] - m.positions[t.x]) + 1e-4f);
}

TEST(Normals, OfLengthZeroAreRepaired) {
  Mesh m = mesh_of(test::plane(1, 1, 2));
  m.normals[4] = vec3(0);
  m.normals[3] = vec3(0, 7, 0);
  EXPECT_EQ(repair_normals(m), 1u);
  EXPECT_NEAR(m.normals[4].y, 1, 1e-6f);
  EXPECT_NEAR(m.normals[3].y, 1, 1e-6f);
}

}  // namespace
}  // namespace vamp
