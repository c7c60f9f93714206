#version 460
// Rays of a tile: the primary hit (new, or the stored one), a mirror's hit, and for every sample a bit for each shadow ray
// that arrives. Nothing is shaded here.
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/bindings.glsl"
#include "shaders/lib/traversal.glsl"
#include "shaders/lib/surface.glsl"
#include "shaders/lib/lights.glsl"
#include "shaders/lib/mirror.glsl"

// Measured on lavapipe: single rays walk fastest two kinds at a time, since while one waits for its box the other computes;
// bundles have enough to compute of their own.
void trace_bundles(vec3 origin, Bundle bundles[RAY_COUNT], out uint free[RAY_COUNT]) {
  uint alone = SAMPLES == 1u ? RAY_COUNT & ~1u : 0u;
  for (uint kind = 0u; kind < alone; kind += 2u) {
    uvec2 pair = unoccluded(origin, bundles[kind], bundles[kind + 1u]);
    free[kind] = pair.x;
    free[kind + 1u] = pair.y;
  }
  for (uint kind = alone; kind < RAY_COUNT; ++kind) free[kind] = unoccluded(origin, bundles[kind]);
}

void main() {
  uvec2 pixel;
  uint index;
  if (!pixel_of_invocation(pixel, index)) return;
  uvec2 global = pixel + uvec2(params.region_x, params.region_y);
  uint seed = random_pixel(global.x, global.y, params.seed);
  Ray ray = primary_ray(global, seed, tile.sample_base / SAMPLES_PER_HIT);

  int triangle;
  if (NEW_HIT) {
    triangle = nearest_hit(ray.origin, ray.direction, 0.0, HUGE).triangle;
    imageStore(hits, hit_place(0u, index), uvec4(uint(triangle + 1)));
  } else {
    triangle = int(imageLoad(hits, hit_place(0u, index)).x) - 1;
  }

  for (uint vertex = 0u; vertex < VERTEX_COUNT; ++vertex) {
    bool hit = triangle >= 0;
    SurfacePoint point = surface_point(ray, max(triangle, 0));
    vec3 origin = leave_surface(point);
    Bundle bundles[RAY_COUNT];
    float ends[LIGHT_ENDS];
    if (LIGHT_SLOTS > 0u) light_ends(point, ends);
    for (uint k = 0u; k < SAMPLES; ++k) {
      LightSample drawn[RAY_COUNT];
      uint unused[SLOT_ENDS];
      vec3 environment;
      draw_shadow_rays(point, ends, seed, tile.sample_base + k, vertex, drawn, unused, environment);
      // The end stays clear of the emitter's own surroundings by the same margin as the start.
      for (uint kind = 0u; kind < RAY_COUNT; ++kind) {
        LightSample s = drawn[kind];
        bundles[kind].direction[k] = s.direction;
        bundles[kind].t_max[k] = hit && s.factor > 0.0 ? s.distance * 0.9999 : -1.0;
      }
    }
    // A hit's samples may come one by one: what the others left stays.
    uint words[VISIBILITY_WORDS];
    for (uint w = 0u; w < VISIBILITY_WORDS; ++w)
      words[w] = NEW_HIT ? 0u : imageLoad(visibility, visibility_place(vertex, w, index)).x;
    uint free[RAY_COUNT];
    trace_bundles(origin, bundles, free);
    for (uint kind = 0u; kind < RAY_COUNT; ++kind)
      for (uint k = 0u; k < SAMPLES; ++k) {
        uint bit = visibility_bit(k, kind);
        for (uint w = 0u; w < VISIBILITY_WORDS; ++w) words[w] |= bit >> 5 == w ? (free[kind] >> k & 1u) << (bit & 31u) : 0u;
      }
    for (uint w = 0u; w < VISIBILITY_WORDS; ++w)
      imageStore(visibility, visibility_place(vertex, w, index), uvec4(words[w]));
    if (MIRROR && vertex == 0u) {
      ray = mirror_ray(ray, point);
      bool mirrors = hit && mirror_f0(point.part) > 0.0;
      int next = nearest_hit(ray.origin, ray.direction, 0.0, mirrors ? HUGE : -1.0).triangle;
      imageStore(hits, hit_place(1u, index), uvec4(uint(next + 1)));
      triangle = next;
    }
  }
}
