#version 460
// Rays of a tile: the primary hit (new, or the stored one), a mirror's hit, and for every sample a bit for each shadow ray
// that arrives. Nothing is shaded here.
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/bindings.glsl"
#include "shaders/lib/traversal.glsl"
#include "shaders/lib/surface.glsl"
#include "shaders/lib/lights.glsl"
#include "shaders/lib/mirror.glsl"

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
    for (uint r = 0u; r < SAMPLES * RAY_COUNT; ++r) {
      uint k = r / max(RAY_COUNT, 1u);
      uint kind = r - k * RAY_COUNT;
      vec3 radiance;
      LightSample s = sample_ray(kind, point, seed, tile.sample_base + k, vertex * PAIR_MIRROR, radiance);
      // The end stays clear of the emitter's own surroundings by the same margin as the start.
      float t_max = hit && s.factor > 0.0 ? s.distance * 0.9999 : -1.0;
      bool arrives = unoccluded(origin, s.direction, 0.0, t_max) && t_max > 0.0;
      uint bit = arrives ? 1u << (kind + vertex * 16u) : 0u;
      for (uint i = 0u; i < SAMPLES; ++i) word[i] |= i == k ? bit : 0u;
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
