#pragma once
// Triangle meshes with known shapes, for the tests of the tree.
#include <cstdint>
#include <random>
#include <vector>

#include "engine/core/vec.h"

namespace vamp {

struct TestMesh {
  std::vector<vec3> positions;
  std::vector<uvec3> triangles;

  // A triangle with vertices of its own.
  void add(const vec3& a, const vec3& b, const vec3& c);
  // u x v cells over the parallelogram corner + s * u_axis + t * v_axis.
  void add_grid(const vec3& corner, const vec3& u_axis, const vec3& v_axis, uint32_t u, uint32_t v);
  // Latitude-longitude sphere with rings x 2 rings cells, bumps of relative height `bumps`; closed.
  void add_sphere(const vec3& center, float radius, uint32_t rings, float bumps = 0);
};

// Uniform points in a box, uniform unit directions.
vec3 random_point(std::mt19937& random, const vec3& lo, const vec3& hi);
vec3 random_direction(std::mt19937& random);

}  // namespace vamp
