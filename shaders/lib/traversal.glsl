// What rays meet: the nearest hit of one, and whether anything is in the way of bundles of them. Answered by the program's own
// tree or, where a kernel is made with RAY_QUERY, by the device's ray queries over the same triangles.

vec4 fetch_triangle(int i) { return STORAGE_FETCH ? triangles_storage[i] : texelFetch(triangle_texels, i); }

// Whether the point (u, v) of a triangle is there at all: glTF's alpha mask.
bool alpha_passes(int triangle, float u, float v);

struct TriangleHit {
  int triangle;  // in the tree's order, -1: none
  float t, u, v;
};

struct Triangle {
  vec3 v0, v1, v2;
  int flags;
};

Triangle fetch_corners(int triangle) {
  vec4 v0 = fetch_triangle(3 * triangle);
  vec4 v1 = fetch_triangle(3 * triangle + 1);
  vec4 v2 = fetch_triangle(3 * triangle + 2);
  return Triangle(v0.xyz, v1.xyz, v2.xyz, int(v1.w));
}

// Shadow rays of one kind from one point, one for each sample: they meet nearly the same boxes and triangles, so that what is
// fetched for one can serve all.
struct Bundle {
  vec3 direction[SAMPLES_PER_HIT];  // SAMPLES of them
  float t_max[SAMPLES_PER_HIT];     // <= 0: not followed
};

// TriangleHit nearest_hit(vec3 origin, vec3 direction, float t_min, float t_max): of triangles between t_min and t_max, both
//   sides; none where t_max <= t_min.
// uint unoccluded(vec3 origin, Bundle bundle): a bit for each ray that is followed and in whose way nothing lies.
// uvec2 unoccluded(vec3 origin, Bundle bundle_x, Bundle bundle_y): of two bundles at once.
#ifdef RAY_QUERY
#include "shaders/lib/traversal_query.glsl"
#else
#include "shaders/lib/traversal_tree.glsl"
#endif
