// Ray against box and triangle: one text for the kernels and for picking on the CPU, so that both give the same answer.
// In GLSL include after the version line; in C++ the names are in vamp::.
//
// A node of the tree is two uvec4, one for each child, with the child's box on a 16-bit grid over the scene:
//   x: lo.x | hi.x << 16   y: lo.y | hi.y << 16   z: lo.z | hi.z << 16   w: int, the child
// child >= 0: inner node `child`, at uvec4 2 * child and 2 * child + 1;
// child < 0: a leaf, ~child = first << 3 | (count - 1), triangles first .. first + count - 1 in the order of the tree.
// A triangle is three vec4: vertex 0 (w: part), vertex 1 (w: flags), vertex 2 (w: 0).
#ifndef VAMP_SHADERS_SHARED_INTERSECT_H
#define VAMP_SHADERS_SHARED_INTERSECT_H

#ifdef __cplusplus
#include <glm/common.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#define VAMP_INTERSECT_FN inline
#define VAMP_PRECISE
namespace vamp {
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

// Once for each ray: t of a plane at grid coordinate q is q * factor + offset.
VAMP_INTERSECT_FN vec3 bvh_ray_factor(vec3 direction, vec3 grid_scale) {
  VAMP_PRECISE vec3 f = vec3(bvh_inverse(direction.x), bvh_inverse(direction.y), bvh_inverse(direction.z)) * grid_scale;
  return f;
}
VAMP_INTERSECT_FN vec3 bvh_ray_offset(vec3 origin, vec3 direction, vec3 grid_origin) {
  VAMP_PRECISE vec3 o =
      (grid_origin - origin) * vec3(bvh_inverse(direction.x), bvh_inverse(direction.y), bvh_inverse(direction.z));
  return o;
}

// Entry and exit of the ray in a child's box, cut to [t_min, t_max]; a hit where entry <= exit. t_min >= 0.
// Exact enough never to miss: the grid boxes stand at least half a cell off the triangles, which covers rounding in
// proportion to the scene, and the exit is stretched by 2^-19, which covers rounding in proportion to the distance.
VAMP_INTERSECT_FN vec2 bvh_slab(uvec4 child, vec3 factor, vec3 offset, float t_min, float t_max) {
  // Where the ray runs backwards along an axis it enters through the high side: the two halves of the word change places.
  // A shift for each lane costs less than the minimum and maximum that would sort them.
  uint x = factor.x < 0.0f ? 16u : 0u;
  uint y = factor.y < 0.0f ? 16u : 0u;
  uint z = factor.z < 0.0f ? 16u : 0u;
  vec3 in_q = vec3(float(child.x >> x & 0xffffu), float(child.y >> y & 0xffffu), float(child.z >> z & 0xffffu));
  vec3 out_q = vec3(float(child.x >> (16u - x) & 0xffffu), float(child.y >> (16u - y) & 0xffffu),
                    float(child.z >> (16u - z) & 0xffffu));
  VAMP_PRECISE vec3 near = in_q * factor + offset;
  VAMP_PRECISE vec3 far = out_q * factor + offset;
  float entry = max(max(near.x, near.y), max(near.z, t_min));
  VAMP_PRECISE float exit = min(min(min(far.x, far.y), far.z) * 1.0000019f, t_max);
  return vec2(entry, exit);
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
