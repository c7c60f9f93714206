#pragma once
// Triangle meshes of parts: mm, UV in mm until they are written.
#include <cstdint>
#include <string>
#include <vector>

#include "tools/shoe/curve.h"

namespace vamp::shoe {

struct Mesh {
  std::vector<Vec3> positions;
  std::vector<Vec3> normals;
  std::vector<Vec2> uvs;  // mm
  std::vector<uint32_t> indices;

  size_t triangles() const { return indices.size() / 3; }
  uint32_t add(const Vec3& position, const Vec2& uv);
  // Two triangles over corners in order; the diagonal is a-c, or b-d when `other_diagonal`.
  void quad(uint32_t a, uint32_t b, uint32_t c, uint32_t d, bool other_diagonal = false);
  void append(const Mesh& other);
  // Angle-weighted vertex normals (Thurmer & Wuthrich 1998).
  void smooth();
  // Scales the UVs so that their area is the surface's: 1 mm of pattern is 1 mm of surface on average.
  void settle_uv_scale();
};

// A grid of points, rows * columns, row by row. Outward is along the columns' direction cross the rows'.
Mesh grid(const std::vector<Vec3>& points, const std::vector<Vec2>& uvs, uint32_t columns);

// What glTF calls a material and the program calls a part.
struct Part {
  std::string name;
  Vec3 colour;  // linear base colour
  double roughness;
  double metallic = 0.0;
  Mesh mesh;
};

}  // namespace vamp::shoe
