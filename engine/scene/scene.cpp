#include "engine/scene/scene.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "engine/core/check.h"

namespace vamp {

int Scene::find_part(std::string_view part_name) const {
  const auto found = std::find_if(parts.begin(), parts.end(), [&](const Part& part) { return part.name == part_name; });
  return found == parts.end() ? -1 : static_cast<int>(found - parts.begin());
}

void finish_scene(Scene& scene) {
  const size_t vertices = scene.positions.size();
  CHECK(scene.normals.size() == vertices && scene.tangents.size() == vertices && scene.uvs.size() == vertices);
  CHECK(scene.triangle_part.size() == scene.triangles.size());
  scene.bounds = {};
  for (Part& part : scene.parts) {
    part.first_triangle = part.triangle_count = 0;
    part.bounds = {};
    part.area = part.uv_area = 0;
  }
  uint32_t previous = 0;
  for (uint32_t i = 0; i < scene.triangles.size(); ++i) {
    const uint32_t number = scene.triangle_part[i];
    CHECK(number < scene.parts.size() && number >= previous);
    previous = number;
    Part& part = scene.parts[number];
    if (part.triangle_count++ == 0) part.first_triangle = i;
    const uvec3 t = scene.triangles[i];
    CHECK(t.x < vertices && t.y < vertices && t.z < vertices);
    const vec3& a = scene.positions[t.x];
    const vec3& b = scene.positions[t.y];
    const vec3& c = scene.positions[t.z];
    part.bounds.extend(a);
    part.bounds.extend(b);
    part.bounds.extend(c);
    part.area += 0.5 * static_cast<double>(glm::length(glm::cross(b - a, c - a)));
    const vec2 e = scene.uvs[t.y] - scene.uvs[t.x];
    const vec2 f = scene.uvs[t.z] - scene.uvs[t.x];
    part.uv_area += 0.5 * std::abs(static_cast<double>(e.x) * static_cast<double>(f.y) -
                                   static_cast<double>(e.y) * static_cast<double>(f.x));
  }
  for (Part& part : scene.parts) {
    scene.bounds.extend(part.bounds);
    // A part whose UVs have no area keeps the scale of the scene's unit.
    const double scale = part.area > 0 && part.uv_area > 0 ? std::sqrt(part.area / part.uv_area) : 1.0;
    part.mm_per_uv = static_cast<float>(static_cast<double>(scene.mm_per_unit) * scale);
  }
}

}  // namespace vamp
