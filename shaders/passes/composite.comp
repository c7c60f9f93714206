#version 460
// Accumulators to the displayed picture, when only what is linear in them changed: emission, exposure, tone curve.
#extension GL_GOOGLE_include_directive : require
#include "shaders/lib/bindings.glsl"
#include "shaders/lib/composite.glsl"

void main() {
  uvec2 pixel;
  uint index;
  if (!pixel_of_invocation(pixel, index)) return;
  uint pixels = region_pixels();
  float mean = 1.0 / float(max(imageLoad(seen, int(pixels + index)).x, 1u));
  vec3 radiance = vec3(0.0);
  for (uint plane = 0u; plane < params.planes; ++plane) {
    vec4 sum = imageLoad(accumulators, int(2u * plane * pixels + index));
    radiance += plane_emission(plane) * sum.rgb * mean;
    if (plane == PLANE_DIRECT && params.background_is_environment == 0u)
      radiance += params.background * (1.0 - sum.w * mean);
  }
  display[index] = display_pixel(radiance);
}
