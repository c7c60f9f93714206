#include "tests/accel/meshes.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

namespace vamp {

void TestMesh::add(const vec3& a, const vec3& b, const vec3& c) {
  const auto n = static_cast<uint32_t>(positions.size());
  positions.insert(positions.end(), {a, b, c});
  triangles.emplace_back(n, n + 1, n + 2);
}

void TestMesh::add_grid(const vec3& corner, const vec3& u_axis, const vec3& v_axis, uint32_t u, uint32_t v) {
  const auto base = static_cast<uint32_t>(positions.size());
  for (uint32_t j = 0; j <= v; ++j)
    for (uint32_t i = 0; i <= u; ++i)
      positions.push_back(corner + u_axis * (static_cast<float>(i) / static_cast<float>(u)) +
                          v_axis * (static_cast<float>(j) / static_cast<float>(v)));
  for (uint32_t j = 0; j < v; ++j)
    for (uint32_t i = 0; i < u; ++i) {
      const uint32_t a = base + j * (u + 1) + i;
      triangles.emplace_back(a, a + 1, a + u + 2);
      triangles.emplace_back(a, a + u + 2, a + u + 1);
    }
}

void TestMesh::add_sphere(const vec3& center, float radius, uint32_t rings, float bumps) {
  const auto base = static_cast<uint32_t>(positions.size());
  const uint32_t columns = 2 * rings;
  const double pi = std::numbers::pi;
  for (uint32_t j = 0; j <= rings; ++j)
    for (uint32_t i = 0; i < columns; ++i) {
      const double theta = pi * j / rings;
      const double phi = 2 * pi * i / columns;
      const bool pole = j == 0 || j == rings;
      const double height = radius * (1.0 + (pole ? 0.0 : bumps * std::sin(9 * theta) * std::cos(7 * phi)));
      const double ring = pole ? 0.0 : std::sin(theta);
      positions.push_back(center + vec3(static_cast<float>(height * ring * std::cos(phi)),
                                        static_cast<float>(height * std::cos(theta)),
                                        static_cast<float>(height * ring * std::sin(phi))));
    }
  for (uint32_t j = 0; j < rings; ++j)
    for (uint32_t i = 0; i < columns; ++i) {
      const uint32_t a = base + j * columns + i;
      const uint32_t b = base + j * columns + (i + 1) % columns;
      if (j > 0) triangles.emplace_back(a, b, a + columns);
      if (j + 1 < rings) triangles.emplace_back(b, b + columns, a + columns);
    }
}

vec3 random_point(std::mt19937& random, const vec3& lo, const vec3& hi) {
  std::uniform_real_distribution<float> unit(0, 1);
  const float x = unit(random);
  const float y = unit(random);
  const float z = unit(random);
  return lo + (hi - lo) * vec3(x, y, z);
}

vec3 random_direction(std::mt19937& random) {
  std::normal_distribution<float> normal;
  while (true) {
    const float x = normal(random);
    const float y = normal(random);
    const float z = normal(random);
    const vec3 v(x, y, z);
    if (glm::length(v) > 1e-3f) return glm::normalize(v);
  }
}

}  // namespace vamp
