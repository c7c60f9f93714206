#include "engine/scene/mesh.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <limits>

namespace vamp {
namespace {

constexpr uint32_t kNone = std::numeric_limits<uint32_t>::max();

// Twice the area times the normal, in double: products of floats are exact there.
dvec3 area_vector(const Mesh& mesh, const uvec3& t) {
  const dvec3 a(mesh.positions[t.x]);
  return glm::cross(dvec3(mesh.positions[t.y]) - a, dvec3(mesh.positions[t.z]) - a);
}

// 0, 1: +X, -X; 2, 3: +Y, -Y; 4, 5: +Z, -Z.
size_t side_of(const dvec3& n) {
  const dvec3 a = glm::abs(n);
  const int axis = a.x >= a.y && a.x >= a.z ? 0 : (a.y >= a.z ? 1 : 2);
  return static_cast<size_t>(2 * axis + (n[axis] < 0 ? 1 : 0));
}

vec2 projected(const vec3& p, size_t side) {
  switch (side) {
    case 0:
      return {-p.z, -p.y};
    case 1:
      return {p.z, -p.y};
    case 2:
      return {p.x, p.z};
    case 3:
      return {p.x, -p.z};
    case 4:
      return {p.x, -p.y};
    default:
      return {-p.x, -p.y};
  }
}

}  // namespace

size_t drop_degenerate_triangles(Mesh& mesh) {
  return std::erase_if(mesh.triangles, [&](const uvec3& t) {
    if (t.x == t.y || t.y == t.z || t.z == t.x) return true;
    const dvec3 n = area_vector(mesh, t);
    return !(glm::dot(n, n) > 0);
  });
}

size_t repair_normals(Mesh& mesh) {
  size_t repaired = 0;
  std::vector<bool> bad(mesh.normals.size(), false);
  for (size_t i = 0; i < mesh.normals.size(); ++i) {
    const float length = glm::length(mesh.normals[i]);
    bad[i] = !(length > 1e-12f);
    if (bad[i])
      mesh.normals[i] = vec3(0);
    else
      mesh.normals[i] /= length;
    if (bad[i]) ++repaired;
  }
  if (repaired == 0) return 0;
  std::vector<dvec3> sums(mesh.normals.size(), dvec3(0));
  for (const uvec3& t : mesh.triangles)
    for (int k = 0; k < 3; ++k)
      if (bad[t[k]]) sums[t[k]] += area_vector(mesh, t);
  for (size_t i = 0; i < mesh.normals.size(); ++i)
    if (bad[i]) mesh.normals[i] = glm::length(sums[i]) > 0 ? vec3(glm::normalize(sums[i])) : vec3(0, 1, 0);
  return repaired;
}

void make_flat_normals(Mesh& mesh) {
  Mesh flat;
  flat.positions.reserve(3 * mesh.triangles.size());
  flat.normals.reserve(3 * mesh.triangles.size());
  for (uvec3& t : mesh.triangles) {
    const vec3 normal(glm::normalize(area_vector(mesh, t)));
    for (int k = 0; k < 3; ++k) {
      flat.positions.push_back(mesh.positions[t[k]]);
      flat.normals.push_back(normal);
      if (!mesh.uvs.empty()) flat.uvs.push_back(mesh.uvs[t[k]]);
      t[k] = static_cast<uint32_t>(flat.positions.size() - 1);
    }
  }
  flat.triangles = std::move(mesh.triangles);
  mesh = std::move(flat);
}

void project_uvs(Mesh& mesh, float mm_per_unit) {
  const size_t count = mesh.positions.size();
  const float scale = mm_per_unit / kGeneratedMmPerUv;
  // The vertex that each original one became on each of the six sides.
  std::vector<std::array<uint32_t, 6>> copies(count, {kNone, kNone, kNone, kNone, kNone, kNone});
  mesh.uvs.assign(count, vec2(0));
  mesh.tangents.clear();
  std::vector<bool> used(count, false);
  for (uvec3& t : mesh.triangles) {
    const size_t side = side_of(area_vector(mesh, t));
    for (int k = 0; k < 3; ++k) {
      const uint32_t v = t[k];
      uint32_t& copy = copies[v][side];
      if (copy == kNone) {
        const vec3 position = mesh.positions[v];
        copy = used[v] ? static_cast<uint32_t>(mesh.positions.size()) : v;
        if (used[v]) {
          const vec3 normal = mesh.normals[v];
          mesh.positions.push_back(position);
          mesh.normals.push_back(normal);
          mesh.uvs.emplace_back(0.0f);
        }
        used[v] = true;
        mesh.uvs[copy] = projected(position, side) * scale;
      }
      t[k] = copy;
    }
  }
}

}  // namespace vamp
