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
  std::vector<uvec4> nodes;     // two for each inner node, the root first
  std::vector<uvec4> list;      // the same boxes depth first, with skips, and its ends
  std::vector<vec4> triangles;  // three for each triangle, in the order of the tree; w: part, flags, 0
  std::vector<uint32_t> order;  // order[i]: the scene's number of the tree's triangle i
  vec3 grid_origin{0};          // a box coordinate q lies at grid_origin + q * grid_scale
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

// With part numbers and flags (alpha mask, double-sided) from the scene's materials.
Bvh build_bvh(const Scene& scene);

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

// Bvh::list of its nodes.
std::vector<uvec4> list_of(const Bvh& bvh);

// Expected cost of a ray through the scene's box: sum over nodes of area / root area * (1 per inner node, 1 per
// triangle of a leaf), measured on the boxes as the kernels see them.
double sah_cost(const Bvh& bvh);

}  // namespace vamp
