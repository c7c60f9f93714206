// Any model by its number and parameters in the papers' order (engine/brdf/lobe.h): for evaluation from tables, tests
// and plots. The shading kernel uses lobe.glsl.
#ifndef BRDF_MODELS_GLSL
#define BRDF_MODELS_GLSL
#include "shaders/brdf/ashikhmin_shirley.glsl"
#include "shaders/brdf/blinn_phong.glsl"
#include "shaders/brdf/cook_torrance.glsl"
#include "shaders/brdf/lafortune.glsl"
#include "shaders/brdf/lambert.glsl"
#include "shaders/brdf/oren_nayar.glsl"
#include "shaders/brdf/ward.glsl"

struct BrdfParams {
  int model, variant;
  real p0, p1, p2, p3, p4, p5;
};

real brdf_eval(BrdfParams b, vec3 wi, vec3 wo) {
  if (b.model == 0) return lambert_eval(b.p0, wi);
  if (b.model == 1) return oren_nayar_eval(b.variant, b.p0, b.p1, wi, wo);
  if (b.model == 2) return blinn_phong_eval(b.variant, b.p0, b.p1, wi, wo);
  if (b.model == 3) return ward_eval(b.variant, b.p0, b.p1, b.p2, wi, wo);
  if (b.model == 4) return cook_torrance_eval(b.variant, b.p0, b.p1, b.p2, wi, wo);
  if (b.model == 5) return lafortune_eval(b.variant, b.p0, b.p1, b.p2, b.p3, b.p4, wi, wo);
  return ashikhmin_shirley_eval(b.variant, b.p0, b.p1, b.p2, b.p3, wi, wo);
}

real brdf_pdf(BrdfParams b, vec3 wi, vec3 wo) {
  if (b.model == 0) return lambert_pdf(wi);
  if (b.model == 1) return oren_nayar_pdf(wi);
  if (b.model == 2) return blinn_phong_pdf(b.p1, wi, wo);
  if (b.model == 3) return ward_pdf(b.p1, b.p2, wi, wo);
  if (b.model == 4) return cook_torrance_pdf(b.p1, wi, wo);
  if (b.model == 5) return lafortune_pdf(b.p1, b.p2, b.p3, b.p4, wi, wo);
  return ashikhmin_shirley_pdf(b.variant, b.p2, b.p3, wi, wo);
}

bool brdf_sample(BrdfParams b, vec3 wo, vec2 u, OUT(vec3) wi, OUT(real) pdf, OUT(real) weight) {
  if (b.model == 0) return lambert_sample(b.p0, u, wi, pdf, weight);
  if (b.model == 1) return oren_nayar_sample(b.variant, b.p0, b.p1, wo, u, wi, pdf, weight);
  if (b.model == 2) return blinn_phong_sample(b.variant, b.p0, b.p1, wo, u, wi, pdf, weight);
  if (b.model == 3) return ward_sample(b.variant, b.p0, b.p1, b.p2, wo, u, wi, pdf, weight);
  if (b.model == 4) return cook_torrance_sample(b.variant, b.p0, b.p1, b.p2, wo, u, wi, pdf, weight);
  if (b.model == 5) return lafortune_sample(b.variant, b.p0, b.p1, b.p2, b.p3, b.p4, wo, u, wi, pdf, weight);
  return ashikhmin_shirley_sample(b.variant, b.p0, b.p1, b.p2, b.p3, wo, u, wi, pdf, weight);
}

#endif
