// Stands in for shaders/brdf/lobe.glsl where the shading kernel is built with textbook forms (bench/CMakeLists.txt): its
// guard, the same interface and constants, one branch a model, windows and cuts as there. Models' usual variants only.
#ifndef LOBE_GLSL
#define LOBE_GLSL
#include "bench/textbook/textbook.glsl"
#include "shaders/brdf/lobe_tags.h"

struct LobeView {
  vec3 wo;
  real window;
};

LobeView lobe_view(uint tag, vec4 k, vec3 wo) {
  LobeView v;
  v.wo = vec3(wo.xy, max(wo.z, REAL(1e-6)));
  v.window = (tag & LOBE_TAG_DIFFUSE) != 0u ? REAL(1.0) : clamp(wo.z / REAL(0.03), REAL(0.0), REAL(1.0));
  return v;
}

real lobe_eval_view(uint tag, vec4 k, vec3 wi, LobeView v) {
  if (wi.z <= REAL(0.0)) return REAL(0.0);
  uint model = tag >> LOBE_TAG_MODEL_SHIFT & 7u;
  vec3 h = normalize(wi + v.wo);
  real oh = dot(v.wo, h);
  real value = REAL(0.0);
  // k holds widths as log2(e) / alpha^2 and exponents halved.
  switch (model) {
    case 0u: value = wi.z; break;
    case 1u: value = textbook_oren_nayar(k.x, k.y, wi, v.wo); break;
    case 2u: value = textbook_blinn_phong(REAL(2.0) * k.x, h) * wi.z; break;
    case 3u:
      value = textbook_gauss(BRDF_LN2 * k.x, BRDF_LN2 * k.y, h) / (REAL(4.0) * oh * oh * pow(h.z, REAL(4.0))) * wi.z;
      break;
    case 4u:
      value = textbook_schlick(k.z, oh) * textbook_cook_torrance(BRDF_LN2 * k.x, h, oh, wi.z, v.wo.z) * wi.z;
      break;
    case 5u: value = pow(max(k.x * wi.x * v.wo.x + k.y * wi.y * v.wo.y + k.z * wi.z * v.wo.z, REAL(0.0)), k.w) * wi.z; break;
    case 6u:
      value = textbook_schlick(k.z, oh) * textbook_ashikhmin_shirley(REAL(2.0) * k.x, REAL(2.0) * k.y, h, oh, wi.z, v.wo.z) * wi.z;
      break;
  }
  return value * v.window;
}

#endif
