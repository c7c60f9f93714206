// Accumulators to what is shown: sums over planes of emission times mean, exposure, tone curve, sRGB.
#include "shaders/shared/tonemap.h"

// What a unit of plane `plane` is worth.
vec3 plane_emission(uint plane) {
  if (plane == PLANE_DIRECT) return vec3(1.0);
  uint light = plane - PLANE_LIGHTS;
  if (light < params.light_count) return params.emission[light];
  if (AMBIENT && light == params.light_count) return params.ambient;
  return vec3(params.environment_intensity);
}

uint display_pixel(vec3 radiance) {
  vec3 c = radiance * params.exposure;
  if (params.tone_map == TONE_CURVE_NEUTRAL) c = tone_neutral(c);
  return packUnorm4x8(vec4(srgb_encode(c.x), srgb_encode(c.y), srgb_encode(c.z), 1.0));
}

// sum - rest grows by `value`, all but exactly (Kahan 1965).
void add_compensated(inout vec4 sum, inout vec4 rest, vec4 value) {
  precise vec4 y = value - rest;
  precise vec4 t = sum + y;
  precise vec4 lost = (t - sum) - y;
  rest = lost;
  sum = t;
}
