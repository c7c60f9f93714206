// Ray against box and triangle: one text for the kernels and for picking on the CPU, so that both give the same answer.
// In GLSL include after the version line; in C++ the names are in vamp::.
//
// A box is a uvec4 on a 16-bit grid over the scene; its high sides are stored less 32768, as a signed number:
//   x: lo.x | (hi.x - 32768) << 16   y, z: likewise   w: int, what is inside
// A node of the tree is two of them, one for each child. w >= 0: inner node w, at uvec4 2 * w and 2 * w + 1;
// w < 0: a leaf, ~w = first << 3 | (count - 1), triangles first .. first + count - 1 in the order of the tree.
// The list of the same boxes for rays that only ask whether anything is in the way: depth first, with skips (Smits 1998,
// "Efficiency issues for ray tracing"). w >= 0: where to go on when the box is missed, else with the next one; w < 0: a leaf
// as above. It ends with BVH_LIST_ENDS boxes of the whole grid whose w is BVH_DONE.
// A triangle is three vec4: vertex 0 (w: part), vertex 1 (w: flags), vertex 2 (w: 0).
#ifndef VAMP_SHADERS_SHARED_INTERSECT_H
#define VAMP_SHADERS_SHARED_INTERSECT_H

#ifdef __cplusplus
#include <glm/common.hpp>
#include <glm/ext/vector_int2.hpp>
#include <glm/ext/vector_int3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#define VAMP_INTERSECT_FN inline
#define VAMP_PRECISE
namespace vamp {
using glm::floatBitsToInt;
using glm::ivec2;
using glm::ivec3;
using glm::max;
using glm::min;
using glm::uint;
using glm::uvec4;
using glm::vec2;
using glm::vec3;
using glm::vec4;
#else
#define VAMP_INTERSECT_FN
#define VAMP_PRECISE precise
#endif

#define BVH_STACK_SIZE 40
#define BVH_DONE (-0x7fffffff)
#define BVH_LIST_ENDS 2
// Flags in the w of vertex 1 (a float that holds a small integer).
#define TRIANGLE_ALPHA_MASK 1
#define TRIANGLE_DOUBLE_SIDED 2

VAMP_INTERSECT_FN float isect_dot(vec3 a, vec3 b) {
  VAMP_PRECISE float d = a.x * b.x + a.y * b.y + a.z * b.z;
  return d;
}

// 1 / d without infinities: components below 1e-18 (the ray is a unit vector) count as 1e-18 with their sign.
VAMP_INTERSECT_FN float bvh_inverse(float d) {
  if (d >= 0.0f) return 1.0f / max(d, 1e-18f);
  return 1.0f / min(d, -1e-18f);
}

// What boxes need of a ray: a low side lies at q * factor + offset along it. A high side is read with the low one still in
// the lower half of its word: a fraction of a cell, which the builder counts in, and no work to take them apart.
struct BoxRay {
  vec3 factor, offset;
  vec3 high_factor, high_offset;
};

VAMP_INTERSECT_FN BoxRay box_ray(vec3 origin, vec3 direction, vec3 grid_origin, vec3 grid_scale) {
  VAMP_PRECISE vec3 inverse = vec3(bvh_inverse(direction.x), bvh_inverse(direction.y), bvh_inverse(direction.z));
  BoxRay ray;
  ray.factor = inverse * grid_scale;
  ray.offset = (grid_origin - origin) * inverse;
  ray.high_factor = ray.factor * (1.0f / 65536.0f);
  ray.high_offset = ray.offset + ray.factor * 32768.0f;
  return ray;
}

// Entry and exit of the ray in a box, cut to [t_min, t_max]; a hit where entry <= exit. t_min >= 0. All four are the bits of
// floats, which as integers keep the order of numbers from 0 up, and are negative for negative numbers: that is all it takes,
// and an integer minimum costs a third of one that minds NaN. There are none: bvh_inverse() is finite.
// Exact enough never to miss: with u = 2^-24, D the distance from the origin to the grid along an axis and S the grid's extent
// there, the high side is wrong by at most u (3 D + 2.5 S), the low one by less. Boxes stand a quarter of a cell (64 u S) off
// their triangles, which covers D up to 20 S; beyond that the error is in proportion to t, at most 9 u where division rounds
// as Vulkan allows, and the exit is stretched by 32 units in the last place, which are at least 32 u.
VAMP_INTERSECT_FN ivec2 box_span(uvec4 box, BoxRay ray, int t_min, int t_max) {
  ivec3 word = ivec3(box);
  VAMP_PRECISE vec3 low = vec3(word & 0xffff) * ray.factor + ray.offset;
  VAMP_PRECISE vec3 high = vec3(word) * ray.high_factor + ray.high_offset;
  ivec3 a = floatBitsToInt(low);
  ivec3 b = floatBitsToInt(high);
  ivec3 near = min(a, b);
  ivec3 far = max(a, b);
  return ivec2(max(max(near.x, near.y), max(near.z, t_min)), min(min(far.x, far.y), min(far.z, t_max)) + 32);
}

// Two unit vectors across a unit direction (Duff et al. 2017, "Building an orthonormal basis, revisited"): once a ray.
VAMP_INTERSECT_FN vec3 ray_side(vec3 d) {
  float s = d.z >= 0.0f ? 1.0f : -1.0f;
  VAMP_PRECISE float a = -1.0f / (s + d.z);
  VAMP_PRECISE vec3 side = vec3(1.0f + s * d.x * d.x * a, s * d.x * d.y * a, -s * d.x);
  return side;
}
VAMP_INTERSECT_FN vec3 ray_above(vec3 d) {
  float s = d.z >= 0.0f ? 1.0f : -1.0f;
  VAMP_PRECISE float a = -1.0f / (s + d.z);
  VAMP_PRECISE vec3 above = vec3(d.x * d.y * a, s + d.y * d.y * a, -d.y);
  return above;
}

// Both sides of a triangle; side = ray_side(direction), above = ray_above(direction), direction unit. Gives t, u, v and in
// w 1 for a hit with t_min < t < t_max, else 0. The point is (1 - u - v) * v0 + u * v1 + v * v2.
// Watertight after Woop, Benthin, Wald 2013, "Watertight ray/triangle intersection", with a rotation in place of their
// shear: a vertex comes to the same 2D point in each of its triangles, and the sign of a difference of two rounded
// products is never the wrong one, at worst it is 0, which counts as inside.
VAMP_INTERSECT_FN vec4 intersect_triangle(vec3 origin, vec3 direction, vec3 side, vec3 above, vec3 v0, vec3 v1, vec3 v2,
                                          float t_min, float t_max) {
  VAMP_PRECISE vec3 p0 = v0 - origin;
  VAMP_PRECISE vec3 p1 = v1 - origin;
  VAMP_PRECISE vec3 p2 = v2 - origin;
  VAMP_PRECISE float x0 = isect_dot(side, p0);
  VAMP_PRECISE float x1 = isect_dot(side, p1);
  VAMP_PRECISE float x2 = isect_dot(side, p2);
  VAMP_PRECISE float y0 = isect_dot(above, p0);
  VAMP_PRECISE float y1 = isect_dot(above, p1);
  VAMP_PRECISE float y2 = isect_dot(above, p2);
  VAMP_PRECISE float w = x1 * y2 - y1 * x2;
  VAMP_PRECISE float u = x2 * y0 - y2 * x0;
  VAMP_PRECISE float v = x0 * y1 - y0 * x1;
  VAMP_PRECISE float sum = w + u + v;
  bool inside = (min(w, min(u, v)) >= 0.0f || max(w, max(u, v)) <= 0.0f) && sum != 0.0f;
  VAMP_PRECISE float inverse = 1.0f / (sum != 0.0f ? sum : 1.0f);
  VAMP_PRECISE float b1 = u * inverse;
  VAMP_PRECISE float b2 = v * inverse;
  VAMP_PRECISE float t =
      isect_dot(direction, p0) * (w * inverse) + isect_dot(direction, p1) * b1 + isect_dot(direction, p2) * b2;
  bool hit = inside && t > t_min && t < t_max;
  return vec4(t, b1, b2, hit ? 1.0f : 0.0f);
}

#ifdef __cplusplus
}  // namespace vamp
#endif
#endif
