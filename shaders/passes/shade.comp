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

// Planes to which each sample adds one value: all of them, but where lights are drawn only what is seen directly, ambient
// and environment, whose planes follow those of all lights.
const uint EVEN_PLANES = PLANE_LIGHTS + RAY_COUNT - LIGHT_SLOTS;
const uint DRAWN_LIGHTS = SAMPLES * SLOT_ENDS;
const uint DRAWN_PLANES = LIGHT_SLOTS > 0u ? LIGHT_COUNT : 0u;

// Light that one vertex of the path sends towards the viewer: a value for each sample and shadow ray.
void shade_vertex(Ray ray, int triangle, uint seed, uint index, uint vertex, float throughput,
                  out vec3 light[DIRECTION_COUNT], out uint drawn[DRAWN_LIGHTS], inout uint clusters,
                  out SurfacePoint point) {
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
  float ends[LIGHT_ENDS];
  if (LIGHT_SLOTS > 0u) light_ends(point, ends);
  for (uint k = 0u; k < SAMPLES; ++k) {
    LightSample rays[RAY_COUNT];
    uint lights_of_rays[SLOT_ENDS];
    vec3 environment;
    draw_shadow_rays(point, ends, seed, tile.sample_base + k, vertex, rays, lights_of_rays, environment);
    for (uint slot = 0u; slot < LIGHT_SLOTS; ++slot) drawn[k * LIGHT_SLOTS + slot] = lights_of_rays[slot];
    for (uint kind = 0u; kind < RAY_COUNT; ++kind) {
      LightSample s = rays[kind];
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
  for (uint d = 0u; d < DIRECTION_COUNT; ++d) light[d] = value[d] * factor[d];
}

// A pixel's accumulator of one plane. A sample at a time is added, so that any batching gives the same bits.
struct Sum {
  vec4 sum, rest;
};
int place_of_sum(uint plane, uint index) { return int(2u * plane * region_pixels() + index); }
Sum load_sum(uint plane, uint index) {
  int at = place_of_sum(plane, index);
  return Sum(imageLoad(accumulators, at), imageLoad(accumulators, at + int(region_pixels())));
}
void store_sum(uint plane, uint index, Sum s) {
  int at = place_of_sum(plane, index);
  imageStore(accumulators, at, s.sum);
  imageStore(accumulators, at + int(region_pixels()), s.rest);
}
void add_to_light(uint light, uint index, vec3 value) {
  Sum s = load_sum(PLANE_LIGHTS + light, index);
  add_compensated(s.sum, s.rest, vec4(value, 0.0));
  store_sum(PLANE_LIGHTS + light, index, s);
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
  vec3 light[DIRECTION_COUNT], mirrored_light[DIRECTION_COUNT];
  uint drawn[DRAWN_LIGHTS], mirrored_drawn[DRAWN_LIGHTS];
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
  shade_vertex(ray, triangle, seed, index, 0u, 1.0 - fresnel, light, drawn, clusters, point);
  if (MIRROR) {
    Ray mirrored = mirror_ray(ray, point);
    int next = int(imageLoad(hits, hit_place(1u, index)).x) - 1;
    SurfacePoint reflected;
    shade_vertex(mirrored, fresnel > 0.0 ? next : -1, seed, index, 1u, fresnel, mirrored_light, mirrored_drawn, clusters,
                 reflected);
    reflected_light = light_hit(mirrored.origin, mirrored.direction, next >= 0 ? reflected.t : HUGE);
    if (fresnel > 0.0 && next < 0 && reflected_light < 0)
      direct.rgb += fresnel * (ENVIRONMENT || sees_environment ? environment_radiance(mirrored.direction) : params.background);
  }

  uint count = tile.sample_base + SAMPLES;
  bool shown_to_someone = tile.weights_alone == 0u;
  if (shown_to_someone) {
    imageStore(seen, int(index), uvec4(clusters));
    imageStore(seen, int(region_pixels() + index), uvec4(count));
  }

  // Of a light in a mirror: that has no weights.
  float reflectance = shown_to_someone ? fresnel : 0.0;
  if (LIGHT_SLOTS > 0u) {
    uint fresh_planes = tile.sample_base > 0u ? 0u : LIGHT_COUNT;
    for (uint i = 0u; i < fresh_planes; ++i) store_sum(PLANE_LIGHTS + i, index, Sum(vec4(0.0), vec4(0.0)));
    for (uint k = 0u; k < SAMPLES; ++k) {
      for (uint slot = 0u; slot < LIGHT_SLOTS; ++slot) {
        add_to_light(drawn[k * LIGHT_SLOTS + slot], index, light[k * RAY_COUNT + slot]);
        if (MIRROR) add_to_light(mirrored_drawn[k * LIGHT_SLOTS + slot], index, mirrored_light[k * RAY_COUNT + slot]);
      }
      if (MIRROR) add_to_light(uint(max(reflected_light, 0)), index, vec3(reflected_light < 0 ? 0.0 : reflectance));
    }
  }
  float mean = 1.0 / float(count);
  vec3 radiance = vec3(0.0);
  for (uint i = 0u; i < EVEN_PLANES; ++i) {
    uint plane = i > PLANE_DIRECT ? i + DRAWN_PLANES : i;
    Sum s = Sum(vec4(0.0), vec4(0.0));
    if (tile.sample_base > 0u) s = load_sum(plane, index);
    for (uint k = 0u; k < SAMPLES; ++k) {
      vec4 c = direct;
      if (i > PLANE_DIRECT) {
        uint d = k * RAY_COUNT + LIGHT_SLOTS + i - PLANE_LIGHTS;
        c = vec4(light[d], 0.0);
        if (MIRROR) c.rgb += mirrored_light[d];
        if (MIRROR && int(plane - PLANE_LIGHTS) == reflected_light) c.rgb += vec3(reflectance);
      }
      add_compensated(s.sum, s.rest, c);
    }
    store_sum(plane, index, s);
    radiance += plane_emission(plane) * s.sum.rgb * mean;
    if (i == PLANE_DIRECT && !sees_environment) radiance += params.background * (1.0 - s.sum.w * mean);
    uint after_direct = i == PLANE_DIRECT ? DRAWN_PLANES : 0u;
    for (uint l = PLANE_LIGHTS; l < PLANE_LIGHTS + after_direct; ++l)
      radiance += plane_emission(l) * imageLoad(accumulators, place_of_sum(l, index)).rgb * mean;
  }
  uint shown = display_pixel(radiance);
  uvec2 end = min(uvec2(tile.stride), uvec2(tile.x + tile.width, tile.y + tile.height) - pixel);
  if (LIST) end = uvec2(shown_to_someone ? 1u : 0u);
  for (uint y = 0u; y < end.y; ++y)
    for (uint x = 0u; x < end.x; ++x) display[index + y * params.region_width + x] = shown;
}
