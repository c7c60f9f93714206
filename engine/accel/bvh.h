#pragma once
// The tree that rays walk, built on the CPU, in the layout that the kernels read (shaders/shared/intersect.h).
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "engine/core/vec.h"
#include "engine/scene/bounds.h"

namespace vamp {

struct Scene;

struct Bvh {
  std::vector<uvec4> nodes;        // two for each inner node, the root first
  std::vector<uvec4> list;         // the same boxes depth first, with skips, and its ends
  std::vector<uint32_t> list_box;  // list[i] holds the box of nodes[list_box[i]]
  std::vector<vec4> triangles;     // three for each triangle, in the order of the tree; w: part, flags, 0
  std::vector<uint32_t> order;     // order[i]: the scene's number of the tree's triangle i
  vec3 grid_origin{0};             // a box coordinate q lies at grid_origin + q * grid_scale
  vec3 grid_scale{1};
  uint32_t depth = 0;  // of inner nodes, at most BVH_STACK_SIZE - 1
  Bounds bounds;

  size_t list_end() const { return nodes.size(); }  // where the list's ends begin
  size_t triangle_count() const { return order.size(); }
};

// Binned SAH (16 bins, leaves of at most 4), 32-byte nodes. Any input gives a valid tree: without triangles it holds
// one that no ray hits (order is then empty). Not finite positions are CHECKed; indices too.
Bvh build_bvh(std::span<const vec3> positions, std::span<const uvec3> triangles,
              std::span<const uint32_t> triangle_part = {}, std::span<const uint32_t> part_flags = {});

// TRIANGLE_* flags (alpha mask, double-sided) of each part, from its material.
std::vector<uint32_t> flags_of_parts(const Scene& scene);

struct Hit {
  uint32_t triangle = 0;  // the scene's number
  float t = 0;            // along the ray
  float u = 0;            // the point is (1 - u - v) v0 + u v1 + v v2
  float v = 0;
};

// The nearest triangle (both sides) with t_min < t < t_max, in the arithmetic of the kernels. direction: unit.
std::optional<Hit> pick(const Bvh& bvh, const vec3& origin, const vec3& direction, float t_min = 0,
                        float t_max = 3.4e38f);

// Any triangle between t_min and t_max.
bool occluded(const Bvh& bvh, const vec3& origin, const vec3& direction, float t_min, float t_max);

// Makes boxes, grid and bounds fit triangles that have moved (bvh.triangles; finite). The tree keeps its shape and its
// order, so that what was far apart before may share boxes that it would not share in a new tree: see box_cost(). Rays
// hit what they would hit in a new tree.
void refit_bvh(Bvh& bvh);

// Bvh::list and list_box of its nodes.
void make_list(Bvh& bvh);

// What tells whether a tree has become worse under refits: the sum over boxes of half their surface, in square scene
// units, times 1 per inner node and 1 per triangle of a leaf, measured on the boxes as the kernels see them. In
// proportion to what a ray costs that comes from anywhere near; the box around everything does not count, for it grows
// with whatever moves away and costs little.
double box_cost(const Bvh& bvh);

// Expected cost of a ray through the scene's box (surface-area heuristic): 1 and box_cost over the box's own half
// surface.
double sah_cost(const Bvh& bvh);

}  // namespace vamp
