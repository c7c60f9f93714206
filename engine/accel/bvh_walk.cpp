#include <array>

#include "engine/accel/bvh.h"
#include "engine/accel/bvh_box.h"
#include "engine/core/check.h"
#include "shaders/shared/intersect.h"

namespace vamp {
namespace {

// The first triangle of a leaf that the ray hits, or the nearest one: visit(slot, hit) returns the new t_max.
template <class Visit>
void visit_leaf(const Bvh& bvh, int32_t inside, const vec3& origin, const vec3& direction, float t_min, float& t_max,
                Visit visit) {
  const uint32_t leaf = static_cast<uint32_t>(~inside);
  const uint32_t first = leaf >> 3;
  for (uint32_t slot = first; slot <= first + (leaf & 7u); ++slot) {
    const vec4* v = &bvh.triangles[3 * static_cast<size_t>(slot)];
    const vec4 hit = intersect_triangle(origin, direction, ray_side(direction), ray_above(direction), vec3(v[0]),
                                        vec3(v[1]), vec3(v[2]), t_min, t_max);
    if (hit.w > 0) t_max = visit(slot, hit);
  }
}

}  // namespace

std::optional<Hit> pick(const Bvh& bvh, const vec3& origin, const vec3& direction, float t_min, float t_max) {
  const BoxRay ray = box_ray(origin, direction, bvh.grid_origin, bvh.grid_scale);
  std::optional<Hit> nearest;
  std::array<int32_t, BVH_STACK_SIZE> stack;
  size_t top = 0;
  int32_t node = 0;
  while (true) {
    if (node >= 0) {
      const uvec4& c0 = bvh.nodes[2 * static_cast<size_t>(node)];
      const uvec4& c1 = bvh.nodes[2 * static_cast<size_t>(node) + 1];
      const ivec2 s0 = box_span(c0, ray, floatBitsToInt(t_min), floatBitsToInt(t_max));
      const ivec2 s1 = box_span(c1, ray, floatBitsToInt(t_min), floatBitsToInt(t_max));
      const bool hit0 = s0.x <= s0.y;
      const bool hit1 = s1.x <= s1.y;
      if (hit0 || hit1) {
        const bool first0 = hit0 && (!hit1 || s0.x <= s1.x);
        node = static_cast<int32_t>(first0 ? c0.w : c1.w);
        if (hit0 && hit1) {
          DCHECK(top < stack.size());
          stack[top++] = static_cast<int32_t>(first0 ? c1.w : c0.w);
        }
        continue;
      }
    } else {
      visit_leaf(bvh, node, origin, direction, t_min, t_max, [&](uint32_t slot, const vec4& hit) {
        nearest = Hit{bvh.order[slot], hit.x, hit.y, hit.z};
        return hit.x;
      });
    }
    if (top == 0) return nearest;
    node = stack[--top];
  }
}

bool occluded(const Bvh& bvh, const vec3& origin, const vec3& direction, float t_min, float t_max) {
  const BoxRay ray = box_ray(origin, direction, bvh.grid_origin, bvh.grid_scale);
  bool found = false;
  for (size_t at = 0; at < bvh.list_end() && !found;) {
    const uvec4& box = bvh.list[at];
    const ivec2 span = box_span(box, ray, floatBitsToInt(t_min), floatBitsToInt(t_max));
    const int32_t inside = static_cast<int32_t>(box.w);
    const bool hit = span.x <= span.y;
    if (hit && inside < 0)
      visit_leaf(bvh, inside, origin, direction, t_min, t_max, [&](uint32_t, const vec4&) {
        found = true;
        return t_max;
      });
    at = hit || inside < 0 ? at + 1 : static_cast<size_t>(inside);
  }
  return found;
}

double box_cost(const Bvh& bvh) {
  double sum = 0;
  for (const uvec4& child : bvh.nodes) {
    const int32_t reference = static_cast<int32_t>(child.w);
    const double tests = reference >= 0 ? 1.0 : static_cast<double>((~reference & 7) + 1);
    sum += tests * half_area(child, bvh.grid_scale);
  }
  return sum;
}

double sah_cost(const Bvh& bvh) {
  if (bvh.triangle_count() == 0) return 0;
  const vec3 size = bvh.bounds.size();
  const double root = static_cast<double>(size.x) * static_cast<double>(size.y) +
                      static_cast<double>(size.y) * static_cast<double>(size.z) +
                      static_cast<double>(size.z) * static_cast<double>(size.x);
  return root > 0 ? 1 + box_cost(bvh) / root : 0;
}

}  // namespace vamp
