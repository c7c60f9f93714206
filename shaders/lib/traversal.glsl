// Rays against the tree of triangles (shaders/shared/intersect.h): for the nearest hit with a stack, nearer child first; for
// any hit along the list with skips, two rays at a time.

uvec4 fetch_node(int i) { return STORAGE_FETCH ? nodes_storage[i] : floatBitsToUint(texelFetch(nodes_texels, i)); }
uvec4 fetch_box(int i) { return STORAGE_FETCH ? boxes_storage[i] : floatBitsToUint(texelFetch(box_texels, i)); }
vec4 fetch_triangle(int i) { return STORAGE_FETCH ? triangles_storage[i] : texelFetch(triangle_texels, i); }

// Whether the point (u, v) of a triangle is there at all: glTF's alpha mask.
bool alpha_passes(int triangle, float u, float v);

struct TriangleHit {
  int triangle;  // in the tree's order, -1: none
  float t, u, v;
};

// A triangle that the ray hits between t_min and t_max, as intersect_triangle() gives it; w: 0 where it does not.
vec4 hit_triangle(int triangle, vec3 origin, vec3 direction, vec3 side, vec3 above, float t_min, float t_max) {
  vec4 v0 = fetch_triangle(3 * triangle);
  vec4 v1 = fetch_triangle(3 * triangle + 1);
  vec4 v2 = fetch_triangle(3 * triangle + 2);
  vec4 r = intersect_triangle(origin, direction, side, above, v0.xyz, v1.xyz, v2.xyz, t_min, t_max);
  bool solid = r.w > 0.0;
  if (ALPHA_MASK) solid = solid && ((int(v1.w) & TRIANGLE_ALPHA_MASK) == 0 || alpha_passes(triangle, r.y, r.z));
  return vec4(r.xyz, solid ? 1.0 : 0.0);
}

// Measured fastest on lavapipe: while-while, a local stack with a sentinel at its bottom, one `if` for pop, one for push.
TriangleHit nearest_hit(vec3 origin, vec3 direction, float t_min, float t_max) {
  BoxRay ray = box_ray(origin, direction, params.grid_origin, params.grid_scale);
  vec3 side = ray_side(direction);
  vec3 above = ray_above(direction);
  TriangleHit hit = TriangleHit(-1, t_max, 0.0, 0.0);
  int stack[BVH_STACK_SIZE];
  stack[0] = BVH_DONE;
  int top = 1;
  int node = 0;
  while (node != BVH_DONE) {
    // Down to a leaf.
    while (node >= 0) {
      uvec4 c0 = fetch_node(2 * node);
      uvec4 c1 = fetch_node(2 * node + 1);
      ivec2 s0 = box_span(c0, ray, floatBitsToInt(t_min), floatBitsToInt(hit.t));
      ivec2 s1 = box_span(c1, ray, floatBitsToInt(t_min), floatBitsToInt(hit.t));
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
    if (node != BVH_DONE) {
      uint leaf = uint(~node);
      int first = int(leaf >> 3);
      int last = first + int(leaf & 7u);
      for (int i = first; i <= last; ++i) {
        vec4 r = hit_triangle(i, origin, direction, side, above, t_min, hit.t);
        if (r.w > 0.0) hit = TriangleHit(i, r.x, r.y, r.z);
      }
      node = stack[--top];
    }
  }
  return hit;
}

// One of the rays that walk the list together. A subgroup waits at its slowest lane and, within a lane, for each fetch; so
// a ray goes on until it stands before two leaves, and while one ray waits the other computes: 1.3 to 1.4 times as fast as a
// single ray with a stack on lavapipe.
struct Walker {
  BoxRay ray;
  int t_max;   // bits
  int at;      // in the list
  int a, b;    // the leaves before which it stands, 0: none, BVH_DONE: it has seen all
};

// t_max <= 0: a ray that is not to be followed.
Walker start_walk(vec3 origin, vec3 direction, float t_max) {
  BoxRay ray = box_ray(origin, direction, params.grid_origin, params.grid_scale);
  uvec4 everything = uvec4(BVH_WHOLE_GRID, BVH_WHOLE_GRID, BVH_WHOLE_GRID, 0u);
  ivec2 span = box_span(everything, ray, 0, floatBitsToInt(t_max));
  bool any = t_max > 0.0 && span.x <= span.y;
  // The list's end must be hit, or the walk would not stop: by those that miss all, too.
  if (!any) ray = box_ray_of_all();
  return Walker(ray, any ? floatBitsToInt(t_max) : 0, any ? 0 : int(params.list_end), 0, 0);
}

void step_walk(inout Walker w) {
  uvec4 box = fetch_box(w.at);
  ivec2 span = box_span(box, w.ray, 0, w.t_max);
  bool hit = span.x <= span.y;
  int inside = int(box.w);
  int leaf = hit ? min(inside, 0) : 0;
  w.b = w.b < 0 ? w.b : (w.a < 0 ? leaf : 0);
  w.a = w.a < 0 ? w.a : leaf;
  int next = hit || inside < 0 ? w.at + 1 : inside;
  w.at = w.b < 0 ? w.at : next;
}

// Tests the triangles of the leaves before which a walker stands and sends it on; returns whether the way is free of them.
bool pass_leaves(inout Walker w, vec3 origin, vec3 direction, float t_max) {
  vec3 side = ray_side(direction);
  vec3 above = ray_above(direction);
  uint a = uint(~w.a);
  uint b = uint(~w.b);
  bool done = w.b == BVH_DONE;
  int first_b = done ? 0 : int(b >> 3);
  int last_b = done ? -1 : first_b + int(b & 7u);
  int i = w.a == BVH_DONE ? 0 : int(a >> 3);
  int last_a = w.a == BVH_DONE ? -1 : i + int(a & 7u);
  int last = last_a;
  bool in_a = true;
  bool free = true;
  while (i <= last) {
    vec4 r = hit_triangle(i, origin, direction, side, above, 0.0, t_max);
    if (r.w > 0.0) free = false;
    bool over = in_a && i == last_a;
    i = over ? first_b : i + 1;
    last = over ? last_b : last;
    last = free ? last : -1;
    in_a = in_a && !over;
  }
  w.at = done || !free ? int(params.list_end) : w.at + 1;
  w.b = done || !free ? BVH_DONE : 0;
  w.a = 0;
  return free;
}

// For two rays from one point: true where nothing lies between it and t_max. t_max <= 0: not looked, true.
bvec2 unoccluded(vec3 origin, vec3 direction_x, float t_max_x, vec3 direction_y, float t_max_y) {
  Walker x = start_walk(origin, direction_x, t_max_x);
  Walker y = start_walk(origin, direction_y, t_max_y);
  bvec2 free = bvec2(true);
  bool more = true;
  while (more) {
    x.b = 0;
    y.b = 0;
    while ((x.b & y.b) >= 0) {
      step_walk(x);
      step_walk(y);
    }
    if (!pass_leaves(x, origin, direction_x, t_max_x)) free.x = false;
    if (!pass_leaves(y, origin, direction_y, t_max_y)) free.y = false;
    more = (x.b & y.b) >= 0;
  }
  // lavapipe ends loops silently after 65,535 turns in a kernel: a walk that was cut short has not seen that the way is free.
  return bvec2(free.x && x.b == BVH_DONE, free.y && y.b == BVH_DONE);
}
