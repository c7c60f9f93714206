#include <array>

#include "engine/accel/bvh.h"
#include "engine/core/check.h"
#include "shaders/shared/intersect.h"

namespace vamp {
namespace {

// Walks from the nearer child to the farther; visit(slot) is asked for each triangle and returns the new t_max.
template <class Visit>
void walk(const Bvh& bvh, const vec3& origin, const vec3& direction, float t_min, float t_max, Visit visit) {
  const vec3 factor = bvh_ray_factor(direction, bvh.grid_scale);
  const vec3 offset = bvh_ray_offset(origin, direction, bvh.grid_origin);
  const vec3 side = ray_side(direction);
  const vec3 above = ray_above(direction);
  std::array<int32_t, BVH_STACK_SIZE> stack;
  size_t top = 0;
  int32_t node = 0;
  while (true) {
    if (node >= 0) {
      const uvec4& c0 = bvh.nodes[2 * static_cast<size_t>(node)];
      const uvec4& c1 = bvh.nodes[2 * static_cast<size_t>(node) + 1];
      const vec2 s0 = bvh_slab(c0, factor, offset, t_min, t_max);
      const vec2 s1 = bvh_slab(c1, factor, offset, t_min, t_max);
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
      const uint32_t leaf = static_cast<uint32_t>(~node);
      const uint32_t first = leaf >> 3;
      for (uint32_t slot = first; slot <= first + (leaf & 7u); ++slot) {
        const vec4* v = &bvh.triangles[3 * static_cast<size_t>(slot)];
        const vec4 hit =
            intersect_triangle(origin, direction, side, above, vec3(v[0]), vec3(v[1]), vec3(v[2]), t_min, t_max);
        if (hit.w > 0) t_max = visit(slot, hit);
        if (!(t_max > t_min)) return;
      }
    }
    if (top == 0) return;
    node = stack[--top];
  }
}

double half_area(const Bvh& bvh, const uvec4& child) {
  const auto size = [&](uint32_t lo, uint32_t hi, int axis) {
    return (static_cast<double>(hi) - static_cast<double>(lo)) * static_cast<double>(bvh.grid_scale[axis]);
  };
  const double x = size(child.x & 0xffffu, child.x >> 16, 0);
  const double y = size(child.y & 0xffffu, child.y >> 16, 1);
  const double z = size(child.z & 0xffffu, child.z >> 16, 2);
  return x * y + y * z + z * x;
}

}  // namespace

std::optional<Hit> pick(const Bvh& bvh, const vec3& origin, const vec3& direction, float t_min, float t_max) {
  std::optional<Hit> nearest;
  walk(bvh, origin, direction, t_min, t_max, [&](uint32_t slot, const vec4& hit) {
    nearest = Hit{bvh.order[slot], hit.x, hit.y, hit.z};
    return hit.x;
  });
  return nearest;
}

bool occluded(const Bvh& bvh, const vec3& origin, const vec3& direction, float t_min, float t_max) {
  bool found = false;
  walk(bvh, origin, direction, t_min, t_max, [&](uint32_t, const vec4&) {
    found = true;
    return t_min;
  });
  return found;
}

double sah_cost(const Bvh& bvh) {
  if (bvh.triangle_count() == 0) return 0;
  const vec3 size = bvh.bounds.size();
  const double root = static_cast<double>(size.x) * static_cast<double>(size.y) +
                      static_cast<double>(size.y) * static_cast<double>(size.z) +
                      static_cast<double>(size.z) * static_cast<double>(size.x);
  if (!(root > 0)) return 0;
  double sum = 1;
  for (const uvec4& child : bvh.nodes) {
    const int32_t reference = static_cast<int32_t>(child.w);
    const double tests = reference >= 0 ? 1.0 : static_cast<double>((~reference & 7) + 1);
    sum += tests * half_area(bvh, child) / root;
  }
  return sum;
}

}  // namespace vamp
