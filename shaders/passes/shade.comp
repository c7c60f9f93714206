#version 460
// The only place where light is added: shades the samples of stored hits and visibility bits, in the order of their
// numbers, and shows the new mean. One kernel for fresh and for replayed samples.
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/bindings.glsl"
#include "shaders/lib/traversal.glsl"
#include "shaders/lib/surface.glsl"
#include "shaders/lib/lights.glsl"
#include "shaders/lib/mirror.glsl"
#include "shaders/lib/spmm.glsl"
#include "shaders/lib/composite.glsl"

const uint PLANE_COUNT = PLANE_LIGHTS + RAY_COUNT;

// Light that one vertex of the path sends towards the viewer: a value for each sample and shadow ray.
void shade_vertex(Ray ray, int triangle, uint seed, uint index, uint vertex, float throughput,
                  inout vec3 light[DIRECTION_COUNT], inout uint clusters, out SurfacePoint point) {
  bool hit = triangle >= 0;
  point = surface_point(ray, max(triangle, 0));
  SurfaceFrame frame = surface_frame(point, max(triangle, 0));
  Part part = fetch_part(point.part);
  // A turned texture turns the tangent frame with it.
  vec3 x = part.uv_offset.z * frame.tangent + part.uv_offset.w * frame.bitangent;
  vec3 y = part.uv_offset.z * frame.bitangent - part.uv_offset.w * frame.tangent;
  vec3 z = point.normal;
  vec3 wo = -vec3(dot(x, ray.direction), dot(y, ray.direction), dot(z, ray.direction));

  uint words[VISIBILITY_WORDS];
  for (uint w = 0u; w < VISIBILITY_WORDS; ++w) words[w] = imageLoad(visibility, visibility_place(vertex, w, index)).x;

  vec3 wi[DIRECTION_COUNT];
  vec3 factor[DIRECTION_COUNT];
  vec3 value[DIRECTION_COUNT];
  for (uint k = 0u; k < SAMPLES; ++k) {
    LightSample drawn[RAY_COUNT];
    vec3 environment;
    draw_shadow_rays(point, seed, tile.sample_base + k, vertex, drawn, environment);
    for (uint kind = 0u; kind < RAY_COUNT; ++kind) {
      LightSample s = drawn[kind];
      uint d = k * RAY_COUNT + kind;
      uint bit = visibility_bit(k, kind);
      bool arrives = hit && (words[VISIBILITY_WORDS == 1u ? 0u : bit >> 5] >> (bit & 31u) & 1u) != 0u;
      vec3 radiance = ENVIRONMENT && kind == RAY_COUNT - 1u ? environment : vec3(1.0);
      factor[d] = arrives ? radiance * (s.factor * throughput) : vec3(0.0);
      wi[d] = vec3(dot(x, s.direction), dot(y, s.direction), max(dot(z, s.direction), 0.0));
      value[d] = vec3(0.0);
    }
  }
  vec2 tap = random_pair(seed, tile.sample_base / SAMPLES_PER_HIT, vertex * PAIR_MIRROR + PAIR_TEXEL);
  uint met = 0u;
  spmm_eval(part, frame.uv, tap, wo, wi, value, met);
  clusters |= hit ? met : 0u;
  for (uint d = 0u; d < DIRECTION_COUNT; ++d) light[d] += value[d] * factor[d];
}

void main() {
  uvec2 pixel;
  uint index;
  if (!pixel_of_invocation(pixel, index)) return;
  uvec2 global = pixel + uvec2(params.region_x, params.region_y);
  uint seed = random_pixel(global.x, global.y, params.seed);
  Ray ray = primary_ray(global, seed, tile.sample_base / SAMPLES_PER_HIT);
  int triangle = int(imageLoad(hits, hit_place(0u, index)).x) - 1;

  // What is seen directly is the same for all samples of a hit.
  vec3 light[DIRECTION_COUNT];
  for (uint d = 0u; d < DIRECTION_COUNT; ++d) light[d] = vec3(0.0);
  bool hit = triangle >= 0;
  vec4 direct = vec4(0.0, 0.0, 0.0, hit ? 1.0 : 0.0);
  bool sees_environment = params.background_is_environment != 0u;
  if (!hit && sees_environment) direct.rgb = environment_radiance(ray.direction);

  int reflected_light = -1;
  float fresnel = 0.0;
  if (MIRROR) {
    SurfacePoint point = surface_point(ray, max(triangle, 0));
    float f0 = mirror_f0(point.part);
    fresnel = hit && f0 > 0.0 ? mirror_fresnel(f0, -dot(point.normal, ray.direction)) : 0.0;
  }
  SurfacePoint point;
  uint clusters = tile.sample_base > 0u ? imageLoad(seen, int(index)).x : 0u;
  shade_vertex(ray, triangle, seed, index, 0u, 1.0 - fresnel, light, clusters, point);
  if (MIRROR) {
    Ray mirrored = mirror_ray(ray, point);
    int next = int(imageLoad(hits, hit_place(1u, index)).x) - 1;
    SurfacePoint reflected;
    shade_vertex(mirrored, fresnel > 0.0 ? next : -1, seed, index, 1u, fresnel, light, clusters, reflected);
    reflected_light = light_hit(mirrored.origin, mirrored.direction, next >= 0 ? reflected.t : HUGE);
    if (fresnel > 0.0 && next < 0 && reflected_light < 0)
      direct.rgb += fresnel * (ENVIRONMENT || sees_environment ? environment_radiance(mirrored.direction) : params.background);
  }

  uint pixels = region_pixels();
  uint count = tile.sample_base + SAMPLES;
  bool shown_to_someone = tile.weights_alone == 0u;
  if (shown_to_someone) {
    imageStore(seen, int(index), uvec4(clusters));
    imageStore(seen, int(pixels + index), uvec4(count));
  }

  // Compensated sums, a sample at a time, so that any batching gives the same bits.
  float mean = 1.0 / float(count);
  vec3 radiance = vec3(0.0);
  for (uint plane = 0u; plane < PLANE_COUNT; ++plane) {
    int at = int(2u * plane * pixels + index);
    vec4 sum = vec4(0.0), rest = vec4(0.0);
    if (tile.sample_base > 0u) {
      sum = imageLoad(accumulators, at);
      rest = imageLoad(accumulators, at + int(pixels));
    }
    for (uint k = 0u; k < SAMPLES; ++k) {
      vec4 c = direct;
      if (plane > PLANE_DIRECT) {
        c = vec4(light[k * RAY_COUNT + plane - PLANE_LIGHTS], 0.0);
        if (MIRROR && shown_to_someone && int(plane - PLANE_LIGHTS) == reflected_light) c.rgb += vec3(fresnel);
      }
      add_compensated(sum, rest, c);
    }
    imageStore(accumulators, at, sum);
    imageStore(accumulators, at + int(pixels), rest);
    radiance += plane_emission(plane) * sum.rgb * mean;
    if (plane == PLANE_DIRECT && !sees_environment) radiance += params.background * (1.0 - sum.w * mean);
  }
  uint shown = display_pixel(radiance);
  uvec2 end = min(uvec2(tile.stride), uvec2(tile.x + tile.width, tile.y + tile.height) - pixel);
  if (LIST) end = uvec2(shown_to_someone ? 1u : 0u);
  for (uint y = 0u; y < end.y; ++y)
    for (uint x = 0u; x < end.x; ++x) display[index + y * params.region_width + x] = shown;
}
