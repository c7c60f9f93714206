#include "tools/shoe/mesh.h"

#include <cmath>

#include "engine/core/check.h"

namespace vamp::shoe {

uint32_t Mesh::add(const Vec3& position, const Vec2& uv) {
  positions.push_back(position);
  uvs.push_back(uv);
  return static_cast<uint32_t>(positions.size() - 1);
}

void Mesh::quad(uint32_t a, uint32_t b, uint32_t c, uint32_t d, bool other_diagonal) {
  if (other_diagonal) {
    indices.insert(indices.end(), {a, b, d, b, c, d});
  } else {
    indices.insert(indices.end(), {a, b, c, a, c, d});
  }
}

void Mesh::append(const Mesh& other) {
  const auto base = static_cast<uint32_t>(positions.size());
  positions.insert(positions.end(), other.positions.begin(), other.positions.end());
  normals.insert(normals.end(), other.normals.begin(), other.normals.end());
  uvs.insert(uvs.end(), other.uvs.begin(), other.uvs.end());
  for (uint32_t i : other.indices) indices.push_back(base + i);
}

void Mesh::smooth() {
  normals.assign(positions.size(), Vec3(0.0));
  for (size_t t = 0; t < indices.size(); t += 3) {
    for (size_t k = 0; k < 3; ++k) {
      const uint32_t i = indices[t + k];
      const Vec3 e = positions[indices[t + (k + 1) % 3]] - positions[i];
      const Vec3 f = positions[indices[t + (k + 2) % 3]] - positions[i];
      const Vec3 n = glm::cross(e, f);
      const double sine = glm::length(n);
      if (sine > 0) normals[i] += n / sine * std::atan2(sine, glm::dot(e, f));
    }
  }
  for (Vec3& n : normals) {
    const double size = glm::length(n);
    CHECK(size > 0);
    n /= size;
  }
}

void Mesh::settle_uv_scale() {
  double area = 0.0, uv_area = 0.0;
  for (size_t t = 0; t < indices.size(); t += 3) {
    const Vec3& p = positions[indices[t]];
    area += glm::length(glm::cross(positions[indices[t + 1]] - p, positions[indices[t + 2]] - p));
    const Vec2 b = uvs[indices[t + 1]] - uvs[indices[t]], c = uvs[indices[t + 2]] - uvs[indices[t]];
    uv_area += std::abs(b.x * c.y - b.y * c.x);
  }
  CHECK(uv_area > 0);
  for (Vec2& uv : uvs) uv *= std::sqrt(area / uv_area);
}

Mesh grid(const std::vector<Vec3>& points, const std::vector<Vec2>& uvs, uint32_t columns) {
  CHECK(points.size() == uvs.size() && columns > 1 && points.size() % columns == 0);
  Mesh mesh;
  mesh.positions = points;
  mesh.uvs = uvs;
  const auto rows = static_cast<uint32_t>(points.size() / columns);
  for (uint32_t j = 0; j + 1 < rows; ++j) {
    for (uint32_t i = 0; i + 1 < columns; ++i) {
      const uint32_t a = j * columns + i;
      mesh.quad(a, a + 1, a + columns + 1, a + columns);
    }
  }
  return mesh;
}

}  // namespace vamp::shoe
