#pragma once
// Small scenes whose pictures are known, made in memory.
#include <memory>
#include <string>
#include <vector>

#include "engine/project/project.h"

namespace vamp {

// Collects triangles by part; parts appear in the order of their first use. Normals are the faces' unless given.
class SceneBuilder {
 public:
  SceneBuilder();
  // A parallelogram corner, corner + a, corner + a + b, corner + b; front side a x b.
  void add_quad(const std::string& part, vec3 corner, vec3 a, vec3 b);
  // Latitude-longitude sphere with smooth normals; `inward` turns them.
  void add_sphere(const std::string& part, vec3 center, float radius, int rings, bool inward = false);
  void add_box(const std::string& part, vec3 lo, vec3 hi);
  // Base colour of a part (rough dielectric: exactly Lambert).
  void set_color(const std::string& part, vec3 color);
  std::shared_ptr<const Scene> build();

 private:
  uint32_t part_of(const std::string& name);
  void add_triangle(uint32_t part, uint32_t a, uint32_t b, uint32_t c);
  uint32_t add_vertex(vec3 p, vec3 n, vec2 uv);

  std::shared_ptr<Scene> scene_;
  struct Triangle {
    uvec3 corners;
    uint32_t part;
  };
  std::vector<Triangle> triangles_;
};

// A project on a scene without any light, background or camera of its own choosing.
Project dark_project(std::shared_ptr<const Scene> scene);

// A material with everything: 2 clusters, all seven models, tilted frames, 81 directions with 4 PCA terms; 16 x 16
// texels, random by `seed`, finite and mild.
SpmmPtr make_rich_material(uint32_t seed);

// A dark base under a highlight of this width, in one texel.
SpmmPtr make_lacquer(float m);

// Puts a material on a part as a preset's.
void put_material(Project& project, const std::string& part, SpmmPtr fit);

}  // namespace vamp
