#version 460
// What lies under each pixel's centre: layer 0 normal and depth (distance along the ray), layer 1 texture coordinates, part
// and cluster. Where nothing is hit: depth 0, part and cluster -1. Made for PIXEL_CENTRES.
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/bindings.glsl"
#include "shaders/lib/traversal.glsl"
#include "shaders/lib/surface.glsl"
#include "shaders/lib/texel.glsl"

void main() {
  uvec2 pixel;
  uint index;
  if (!pixel_of_invocation(pixel, index)) return;
  Ray ray = primary_ray(pixel + uvec2(params.region_x, params.region_y), 0u, 0u);
  int triangle = nearest_hit(ray.origin, ray.direction, 0.0, HUGE).triangle;
  bool hit = triangle >= 0;
  SurfacePoint point = surface_point(ray, max(triangle, 0));
  SurfaceFrame frame = surface_frame(point, max(triangle, 0));
  Part part = fetch_part(point.part);
  // The nearest texel's cluster: half a texel back, and both coordinates rounded up or down.
  float unused;
  vec2 rest;
  uint cluster = texelFetch(texel_texels, tap_texel(part, frame.uv, vec2(0.5), 0u, unused, rest)).y & 255u;
  imageStore(aov, int(index), hit ? vec4(point.normal, point.t) : vec4(0.0));
  imageStore(aov, int(region_pixels() + index),
             hit ? vec4(frame.uv, float(point.part), float(cluster)) : vec4(0.0, 0.0, -1.0, -1.0));
}
