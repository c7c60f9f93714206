#version 460
// Ambient occlusion as a layer of its own: the plain mean of the visibility V of cosine-weighted rays within the AO radius
// (1 where nothing is near). (Silva & Santos 2013, eq. 7 divides by pi as well, which would make an open plane 0.318.)
// Layer 2: sum of V, samples on the surface, 0, 0.
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/bindings.glsl"
#include "shaders/lib/traversal.glsl"
#include "shaders/lib/surface.glsl"
#include "shaders/lib/lights.glsl"

vec3 occlusion_direction(SurfacePoint point, uint seed, uint k) {
  return sample_ambient(point.normal, point.view, random_pair(seed, tile.sample_base + k, PAIR_OCCLUSION), 0.0).direction;
}

void main() {
  uvec2 pixel;
  uint index;
  if (!pixel_of_invocation(pixel, index)) return;
  uvec2 global = pixel + uvec2(params.region_x, params.region_y);
  uint seed = random_pixel(global.x, global.y, params.seed);
  Ray ray = primary_ray(global, seed, tile.sample_base / SAMPLES_PER_HIT);
  int triangle = nearest_hit(ray.origin, ray.direction, 0.0, HUGE).triangle;
  SurfacePoint point = surface_point(ray, max(triangle, 0));
  vec3 origin = leave_surface(point);
  vec4 sum = tile.sample_base > 0u ? imageLoad(aov, int(2u * region_pixels() + index)) : vec4(0.0);
  Bundle bundle;
  for (uint k = 0u; k < SAMPLES; ++k) {
    bundle.direction[k] = occlusion_direction(point, seed, k);
    // Directions under the face but above the shading normal's horizon are no directions of the surface: not counted.
    bool above = triangle >= 0 && dot(bundle.direction[k], point.face) > 0.0;
    bundle.t_max[k] = above ? params.ao_radius : -1.0;
    sum.y += above ? 1.0 : 0.0;
  }
  sum.x += float(bitCount(unoccluded(origin, bundle)));
  imageStore(aov, int(2u * region_pixels() + index), sum);
}
