#version 460
// Pulls weights: adds so many steps along a direction of weights, whose sums were made beforehand, to the picture's sums of
// a list of pixels, and shows the new means. Nothing is traced or shaded.
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
    int at = int(2u * plane * pixels + index);
    vec4 sum = imageLoad(whole, at);
    if (plane == PLANE_DIRECT) {
      // What is seen directly has no weights.
      if (params.background_is_environment == 0u) radiance += params.background * (1.0 - sum.w * mean);
    } else {
      vec4 rest = imageLoad(whole, at + int(pixels));
      add_compensated(sum, rest, tile.step * imageLoad(accumulators, at));
      imageStore(whole, at, sum);
      imageStore(whole, at + int(pixels), rest);
    }
    radiance += plane_emission(plane) * sum.rgb * mean;
  }
  display[index] = display_pixel(radiance);
}
