#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <limits>

#include "engine/core/hash.h"
#include "engine/scene/mesh.h"

namespace vamp {
namespace {

constexpr uint32_t kNone = std::numeric_limits<uint32_t>::max();

// For each vertex the first one with the same position, normal and UV, bit for bit.
std::vector<uint32_t> weld(const Mesh& mesh) {
  using Key = std::array<float, 8>;
  const auto key_of = [&](uint32_t i) {
    const vec3& p = mesh.positions[i];
    const vec3& n = mesh.normals[i];
    const vec2& uv = mesh.uvs[i];
    return Key{p.x, p.y, p.z, n.x, n.y, n.z, uv.x, uv.y};
  };
  const auto count = static_cast<uint32_t>(mesh.positions.size());
  const size_t mask = std::bit_ceil(std::max<size_t>(2 * size_t{count}, 16)) - 1;
  std::vector<uint32_t> table(mask + 1, kNone);
  std::vector<uint32_t> first(count);
  for (uint32_t i = 0; i < count; ++i) {
    const Key key = key_of(i);
    size_t slot = hash64(std::as_bytes(std::span(key))) & mask;
    while (table[slot] != kNone) {
      const Key other = key_of(table[slot]);
      if (std::memcmp(&key, &other, sizeof(Key)) == 0) break;
      slot = (slot + 1) & mask;
    }
    if (table[slot] == kNone) table[slot] = i;
    first[i] = table[slot];
  }
  return first;
}

// Sums around a welded vertex, apart for unmirrored and mirrored triangles.
struct Sums {
  vec3 along_u{0};
  vec3 along_v{0};
  bool any = false;
};

vec3 across(const vec3& v, const vec3& n) { return v - n * glm::dot(n, v); }

vec3 unit_or_zero(const vec3& v) {
  const float length = glm::length(v);
  return length > 1e-20f ? v / length : vec3(0);
}

vec3 any_across(const vec3& n) {
  return glm::normalize(glm::cross(n, std::abs(n.x) < 0.7f ? vec3(1, 0, 0) : vec3(0, 1, 0)));
}

float corner_angle(const vec3& n, const vec3& at, const vec3& b, const vec3& c) {
  const vec3 p = across(b - at, n);
  const vec3 q = across(c - at, n);
  return std::atan2(glm::length(glm::cross(p, q)), glm::dot(p, q));
}

struct Gradient {
  vec3 along_u{0};  // unit dP/du and dP/dv
  vec3 along_v{0};
  int group = -1;  // 0: det < 0, the orientation of an upright picture with v downwards; 1: mirrored; -1: no UV area
};

Gradient gradient_of(const Mesh& mesh, const uvec3& t) {
  const dvec3 e1(mesh.positions[t.y] - mesh.positions[t.x]);
  const dvec3 e2(mesh.positions[t.z] - mesh.positions[t.x]);
  const glm::dvec2 d1(mesh.uvs[t.y] - mesh.uvs[t.x]);
  const glm::dvec2 d2(mesh.uvs[t.z] - mesh.uvs[t.x]);
  const double det = d1.x * d2.y - d1.y * d2.x;
  if (!(std::abs(det) > 1e-30)) return {};
  const double sign = det < 0 ? -1.0 : 1.0;
  const dvec3 u = (e1 * d2.y - e2 * d1.y) * sign;
  const dvec3 v = (e2 * d1.x - e1 * d2.x) * sign;
  if (!(glm::dot(u, u) > 0)) return {};
  return {vec3(glm::normalize(u)), glm::dot(v, v) > 0 ? vec3(glm::normalize(v)) : vec3(0), det < 0 ? 0 : 1};
}

}  // namespace

void make_tangents(Mesh& mesh) {
  const std::vector<uint32_t> first = weld(mesh);
  std::vector<std::array<Sums, 2>> sums(mesh.positions.size());
  std::vector<int8_t> groups;
  groups.reserve(mesh.triangles.size());
  for (const uvec3& t : mesh.triangles) {
    const Gradient g = gradient_of(mesh, t);
    groups.push_back(static_cast<int8_t>(g.group));
    if (g.group < 0) continue;
    for (int k = 0; k < 3; ++k) {
      const uint32_t v = t[k];
      const vec3& n = mesh.normals[v];
      const float angle =
          corner_angle(n, mesh.positions[v], mesh.positions[t[(k + 1) % 3]], mesh.positions[t[(k + 2) % 3]]);
      Sums& s = sums[first[v]][static_cast<size_t>(g.group)];
      s.along_u += unit_or_zero(across(g.along_u, n)) * angle;
      s.along_v += unit_or_zero(across(g.along_v, n)) * angle;
      s.any = true;
    }
  }

  // Write a tangent for each (vertex, group) in use; the second group of a vertex gets a copy of it.
  const size_t count = mesh.positions.size();
  std::vector<std::array<uint32_t, 2>> copies(count, {kNone, kNone});
  mesh.tangents.assign(count, vec4(0));
  for (size_t i = 0; i < mesh.triangles.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      const uint32_t v = mesh.triangles[i][k];
      const auto& pair = sums[first[v]];
      const size_t group = groups[i] >= 0 ? static_cast<size_t>(groups[i]) : (pair[0].any || !pair[1].any ? 0 : 1);
      uint32_t& copy = copies[v][group];
      if (copy == kNone) {
        copy = v;
        if (copies[v][1 - group] != kNone) {
          copy = static_cast<uint32_t>(mesh.positions.size());
          mesh.positions.push_back(vec3(mesh.positions[v]));
          mesh.normals.push_back(vec3(mesh.normals[v]));
          mesh.uvs.push_back(vec2(mesh.uvs[v]));
          mesh.tangents.emplace_back(0.0f);
        }
        const vec3& n = mesh.normals[v];
        vec3 tangent = unit_or_zero(across(pair[group].along_u, n));
        if (tangent == vec3(0)) tangent = any_across(n);
        // The bitangent points against dP/dv; for a normal on the far side of its triangle this flips with it.
        const float towards_v = glm::dot(glm::cross(n, tangent), pair[group].along_v);
        const float sign = towards_v != 0 ? (towards_v < 0 ? 1.0f : -1.0f) : (group == 0 ? 1.0f : -1.0f);
        mesh.tangents[copy] = vec4(tangent, sign);
      }
      mesh.triangles[i][k] = copy;
    }
  }
  // Vertices that no triangle uses.
  for (size_t i = 0; i < mesh.tangents.size(); ++i)
    if (mesh.tangents[i] == vec4(0)) mesh.tangents[i] = vec4(any_across(mesh.normals[i]), 1.0f);
}

}  // namespace vamp
