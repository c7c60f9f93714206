// Rays against the tree of triangles (shaders/shared/intersect.h): for the nearest hit with a stack, nearer child first; for
// any hit along the list with skips, as bundles, which walk as one as long as any of their rays goes on.

uvec4 fetch_node(int i) { return STORAGE_FETCH ? nodes_storage[i] : floatBitsToUint(texelFetch(nodes_texels, i)); }
uvec4 fetch_box(int i) { return STORAGE_FETCH ? boxes_storage[i] : floatBitsToUint(texelFetch(box_texels, i)); }

// Triangle i where the ray hits it between t_min and t_max, as intersect_triangle() gives it; w: 0 where it does not.
vec4 hit_triangle(int i, Triangle triangle, vec3 origin, vec3 direction, vec3 side, vec3 above, float t_min, float t_max) {
  vec4 r = intersect_triangle(origin, direction, side, above, triangle.v0, triangle.v1, triangle.v2, t_min, t_max);
  bool solid = r.w > 0.0;
  if (ALPHA_MASK) solid = solid && ((triangle.flags & TRIANGLE_ALPHA_MASK) == 0 || alpha_passes(i, r.y, r.z));
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
        vec4 r = hit_triangle(i, fetch_corners(i), origin, direction, side, above, t_min, hit.t);
        if (r.w > 0.0) hit = TriangleHit(i, r.x, r.y, r.z);
      }
      node = stack[--top];
    }
  }
  return hit;
}

// A bundle on its way. A subgroup waits at its slowest lane and, within a lane, for each fetch; so a bundle goes on until it
// stands before two leaves, and while one waits another computes.
struct Walker {
  BoxRay ray[SAMPLES_PER_HIT];
  int t_max[SAMPLES_PER_HIT];  // bits; negative: not followed
  int at;             // in the list
  int a, b;           // the leaves before which it stands, 0: none, BVH_DONE: it has seen all
};

Walker start_walk(vec3 origin, Bundle bundle) {
  Walker w;
  w.at = int(params.list_end);
  w.a = 0;
  w.b = 0;
  for (uint k = 0u; k < SAMPLES; ++k) {
    w.ray[k] = box_ray(origin, bundle.direction[k], params.grid_origin, params.grid_scale);
    bool followed = bundle.t_max[k] > 0.0;
    w.t_max[k] = followed ? floatBitsToInt(bundle.t_max[k]) : BVH_DONE;
    w.at = followed ? 0 : w.at;
  }
  return w;
}

void step_walk(inout Walker w) {
  uvec4 box = fetch_box(w.at);
  int inside = int(box.w);
  bool hit = inside == BVH_DONE;
  for (uint k = 0u; k < SAMPLES; ++k) {
    ivec2 span = box_span(box, w.ray[k], 0, w.t_max[k]);
    hit = hit || span.x <= span.y;
  }
  int leaf = hit ? min(inside, 0) : 0;
  w.b = w.b < 0 ? w.b : (w.a < 0 ? leaf : 0);
  w.a = w.a < 0 ? w.a : leaf;
  int next = hit || inside < 0 ? w.at + 1 : inside;
  w.at = w.b < 0 ? w.at : next;
}

// Tests the triangles of the leaves before which a walker stands and sends it on; what is hit is no longer followed.
void pass_leaves(inout Walker w, vec3 origin, Bundle bundle) {
  uint a = uint(~w.a);
  uint b = uint(~w.b);
  bool done = w.b == BVH_DONE;
  int first_b = done ? 0 : int(b >> 3);
  int last_b = done ? -1 : first_b + int(b & 7u);
  int i = w.a == BVH_DONE ? 0 : int(a >> 3);
  int last_a = w.a == BVH_DONE ? -1 : i + int(a & 7u);
  int last = last_a;
  bool in_a = true;
  bool more = true;
  while (i <= last) {
    Triangle triangle = fetch_corners(i);
    more = false;
    for (uint k = 0u; k < SAMPLES; ++k) {
      vec3 direction = bundle.direction[k];
      vec4 r = hit_triangle(i, triangle, origin, direction, ray_side(direction), ray_above(direction), 0.0,
                            intBitsToFloat(w.t_max[k]));
      w.t_max[k] = r.w > 0.0 ? BVH_DONE : w.t_max[k];
      more = more || w.t_max[k] >= 0;
    }
    bool over = in_a && i == last_a;
    i = over ? first_b : i + 1;
    last = over ? last_b : last;
    last = more ? last : -1;
    in_a = in_a && !over;
  }
  w.at = done || !more ? int(params.list_end) : w.at + 1;
  w.b = done || !more ? BVH_DONE : 0;
  w.a = 0;
}

// A bit for each of the bundle's rays that was followed to its end: nothing lies in its way. lavapipe ends loops silently
// after 65,535 turns in a kernel: a walk that was cut short has not seen that the way is free.
uint free_rays(Walker w) {
  uint bits = 0u;
  for (uint k = 0u; k < SAMPLES; ++k) bits |= w.b == BVH_DONE && w.t_max[k] >= 0 ? 1u << k : 0u;
  return bits;
}

uint unoccluded(vec3 origin, Bundle bundle) {
  Walker w = start_walk(origin, bundle);
  while (w.b >= 0) {
    while (w.b >= 0) step_walk(w);
    pass_leaves(w, origin, bundle);
  }
  return free_rays(w);
}

// Two bundles at once.
uvec2 unoccluded(vec3 origin, Bundle bundle_x, Bundle bundle_y) {
  Walker x = start_walk(origin, bundle_x);
  Walker y = start_walk(origin, bundle_y);
  while ((x.b & y.b) >= 0) {
    while ((x.b & y.b) >= 0) {
      step_walk(x);
      step_walk(y);
    }
    pass_leaves(x, origin, bundle_x);
    pass_leaves(y, origin, bundle_y);
  }
  return uvec2(free_rays(x), free_rays(y));
}
