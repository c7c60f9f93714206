// Rays against the tree of triangles: binned-SAH BVH2, 32-byte nodes, ordered for the nearest hit and unordered for any
// hit (measured fastest on lavapipe: while-while, a local stack with a sentinel at its bottom, one `if` for pop, one for push).

uvec4 fetch_node(int i) { return STORAGE_FETCH ? nodes_storage[i] : floatBitsToUint(texelFetch(nodes_texels, i)); }
vec4 fetch_triangle(int i) { return STORAGE_FETCH ? triangles_storage[i] : texelFetch(triangle_texels, i); }

// Whether the point (u, v) of a triangle is there at all: glTF's alpha mask.
bool alpha_passes(int triangle, float u, float v);

struct TriangleHit {
  int triangle;  // in the tree's order, -1: none
  float t, u, v;
};

TriangleHit nearest_hit(vec3 origin, vec3 direction, float t_min, float t_max) {
  vec3 factor = bvh_ray_factor(direction, params.grid_scale);
  vec3 offset = bvh_ray_offset(origin, direction, params.grid_origin);
  vec3 side = ray_side(direction);
  vec3 above = ray_above(direction);
  TriangleHit hit = TriangleHit(-1, t_max, 0.0, 0.0);
  const int DONE = -0x7fffffff;
  int stack[BVH_STACK_SIZE];
  stack[0] = DONE;
  int top = 1;
  int node = 0;
  while (node != DONE) {
    // Down to a leaf.
    while (node >= 0) {
      uvec4 c0 = fetch_node(2 * node);
      uvec4 c1 = fetch_node(2 * node + 1);
      vec2 s0 = bvh_slab(c0, factor, offset, t_min, hit.t);
      vec2 s1 = bvh_slab(c1, factor, offset, t_min, hit.t);
      bool h0 = s0.x <= s0.y;
      bool h1 = s1.x <= s1.y;
      if (!h0 && !h1) {
        node = stack[--top];
      } else {
        bool swap = !h0 || (h1 && s1.x < s0.x);
        node = swap ? int(c1.w) : int(c0.w);
        if (h0 && h1) stack[top++] = swap ? int(c0.w) : int(c1.w);
      }
    }
    if (node != DONE) {
      uint leaf = uint(~node);
      int first = int(leaf >> 3);
      int last = first + int(leaf & 7u);
      for (int i = first; i <= last; ++i) {
        vec4 v0 = fetch_triangle(3 * i);
        vec4 v1 = fetch_triangle(3 * i + 1);
        vec4 v2 = fetch_triangle(3 * i + 2);
        vec4 r = intersect_triangle(origin, direction, side, above, v0.xyz, v1.xyz, v2.xyz, t_min, hit.t);
        bool solid = r.w > 0.0;
        if (ALPHA_MASK) solid = solid && ((int(v1.w) & TRIANGLE_ALPHA_MASK) == 0 || alpha_passes(i, r.y, r.z));
        if (solid) hit = TriangleHit(i, r.x, r.y, r.z);
      }
      node = stack[--top];
    }
  }
  return hit;
}

// True when nothing lies between t_min and t_max.
bool unoccluded(vec3 origin, vec3 direction, float t_min, float t_max) {
  vec3 factor = bvh_ray_factor(direction, params.grid_scale);
  vec3 offset = bvh_ray_offset(origin, direction, params.grid_origin);
  vec3 side = ray_side(direction);
  vec3 above = ray_above(direction);
  const int DONE = -0x7fffffff;
  int stack[BVH_STACK_SIZE];
  stack[0] = DONE;
  int top = 1;
  int node = t_max > t_min ? 0 : DONE;
  bool free = true;
  while (node != DONE) {
    while (node >= 0) {
      uvec4 c0 = fetch_node(2 * node);
      uvec4 c1 = fetch_node(2 * node + 1);
      vec2 s0 = bvh_slab(c0, factor, offset, t_min, t_max);
      vec2 s1 = bvh_slab(c1, factor, offset, t_min, t_max);
      bool h0 = s0.x <= s0.y;
      bool h1 = s1.x <= s1.y;
      if (!h0 && !h1) {
        node = stack[--top];
      } else {
        node = h0 ? int(c0.w) : int(c1.w);
        if (h0 && h1) stack[top++] = int(c1.w);
      }
    }
    if (node != DONE) {
      uint leaf = uint(~node);
      int first = int(leaf >> 3);
      int last = first + int(leaf & 7u);
      for (int i = first; i <= last; ++i) {
        vec4 v0 = fetch_triangle(3 * i);
        vec4 v1 = fetch_triangle(3 * i + 1);
        vec4 v2 = fetch_triangle(3 * i + 2);
        vec4 r = intersect_triangle(origin, direction, side, above, v0.xyz, v1.xyz, v2.xyz, t_min, t_max);
        bool solid = r.w > 0.0;
        if (ALPHA_MASK) solid = solid && ((int(v1.w) & TRIANGLE_ALPHA_MASK) == 0 || alpha_passes(i, r.y, r.z));
        if (solid) free = false;
      }
      --top;
      node = free ? stack[top] : DONE;
    }
  }
  return free;
}
