#pragma once
// A scene as the kernels read it: the tree of triangles and a surface record for each of them
// (shaders/lib/surface.glsl).
#include <memory>
#include <shared_mutex>
#include <span>
#include <vector>

#include "engine/accel/bvh.h"
#include "engine/scene/placement.h"
#include "engine/scene/scene.h"

namespace vamp {

struct SceneTables {
  Bvh bvh;
  std::vector<uvec4> surface;        // four for each triangle, in the order of the tree
  std::vector<uint8_t> alpha;        // alpha masks of the parts that have one
  std::vector<uvec2> alpha_of_part;  // first byte and size (width | height << 16); size 0: none
  // Held by whoever reads while parts may move, and alone by who moves them.
  std::unique_ptr<std::shared_mutex> moving = std::make_unique<std::shared_mutex>();
};

// `visible` says for each part whether its triangles are there.
SceneTables build_scene_tables(const Scene& scene, const std::vector<bool>& visible);

// The same without alpha masks. `motions`: where each part stands; none: as the model has them.
SceneTables build_triangle_tables(const Scene& scene, const std::vector<bool>& visible,
                                  std::span<const RigidMotion> motions);

// Normals and tangents of a triangle into its four texels of SceneTables::surface.
void write_directions(const Scene& scene, uint32_t triangle, const RigidMotion& motion, uvec4* surface);

// Whether some part has an alpha mask, visible or not.
bool has_alpha_mask(const Scene& scene);

// Octahedral unit vectors, 16 bits a component; within 4e-5 rad.
uint32_t pack_normal(const vec3& n);
// 16 and 15 bits; the lowest bit says that the bitangent is flipped.
uint32_t pack_tangent(const vec4& tangent);

}  // namespace vamp
