#version 460
// Rays of a tile: the primary hit (new, or the stored one), a mirror's hit, and for every sample a bit for each shadow ray
// that arrives. Nothing is shaded here.
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/bindings.glsl"
#include "shaders/lib/traversal.glsl"
#include "shaders/lib/surface.glsl"
#include "shaders/lib/lights.glsl"
#include "shaders/lib/mirror.glsl"

const uint RAYS = SAMPLES * RAY_COUNT;

// Rays of a kind stand together: two of them end their walk sooner than two of different kinds.
// Sets the bit of ray r in the word of its sample.
void add_bit(inout uint word[SAMPLES], uint r, uint vertex, bool arrives) {
  uint kind = r / SAMPLES;
  uint sample_of_ray = r - kind * SAMPLES;
  uint bit = arrives ? 1u << (kind + vertex * 16u) : 0u;
  for (uint k = 0u; k < SAMPLES; ++k) word[k] |= k == sample_of_ray ? bit : 0u;
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
    imageStore(hits, int(index), uvec4(uint(triangle + 1)));
  } else {
    triangle = int(imageLoad(hits, int(index)).x) - 1;
  }

  uint word[SAMPLES];
  for (uint k = 0u; k < SAMPLES; ++k) word[k] = 0u;

  for (uint vertex = 0u; vertex < VERTEX_COUNT; ++vertex) {
    bool hit = triangle >= 0;
    SurfacePoint point = surface_point(ray, max(triangle, 0));
    vec3 origin = leave_surface(point);
    vec4 rays[RAYS + 1u];  // direction, distance (<= 0: carries nothing); one more, for pairs
    rays[RAYS] = vec4(0.0, 0.0, 1.0, -1.0);
    for (uint k = 0u; k < SAMPLES; ++k) {
      LightSample drawn[RAY_COUNT];
      vec3 environment;
      draw_shadow_rays(point, seed, tile.sample_base + k, vertex, drawn, environment);
      // The end stays clear of the emitter's own surroundings by the same margin as the start.
      for (uint kind = 0u; kind < RAY_COUNT; ++kind) {
        LightSample s = drawn[kind];
        rays[kind * SAMPLES + k] = vec4(s.direction, hit && s.factor > 0.0 ? s.distance * 0.9999 : -1.0);
      }
    }
    for (uint r = 0u; r < RAYS; r += 2u) {
      vec4 x = rays[r];
      vec4 y = rays[r + 1u];
      bvec2 free = unoccluded(origin, x.xyz, x.w, y.xyz, y.w);
      add_bit(word, r, vertex, free.x && x.w > 0.0);
      add_bit(word, r + 1u, vertex, free.y && y.w > 0.0);
    }
    if (MIRROR && vertex == 0u) {
      ray = mirror_ray(ray, point);
      bool mirrors = hit && mirror_f0(point.part) > 0.0;
      int next = nearest_hit(ray.origin, ray.direction, 0.0, mirrors ? HUGE : -1.0).triangle;
      imageStore(hits, int(region_pixels() + index), uvec4(uint(next + 1)));
      triangle = next;
    }
  }
  for (uint k = 0u; k < SAMPLES; ++k)
    imageStore(visibility, int(((tile.sample_base + k) % SAMPLES_PER_HIT) * region_pixels() + index), uvec4(word[k]));
}
