// Cook and Torrance 1982, "A reflectance model for computer graphics": f = ks F D G / (c iz oz), Beckmann's D, V-groove G.
// m in [0.005, 1], rms slope; f0 in [0,1], or for the exact Fresnel term the index of refraction.
// Variants: 0 modern_schlick, 1 modern_exact (c = 4 and a normalised D: albedo never above 1, Walter et al. 2007,
// eq. 20 and 25), 2 ngan_schlick (c = pi: 4 / pi brighter), 3 original_1982_schlick, 4 original_1982_exact (c = pi and
// no pi in D: 4 times brighter).
// Cannot: tails longer than a Gaussian's; brightness at an angle that multiple scattering would add for m above 0.5.
#ifndef COOK_TORRANCE_GLSL
#define COOK_TORRANCE_GLSL
#include "shaders/brdf/ward.glsl"

bool cook_torrance_is_exact(int variant) { return variant == 1 || variant == 4; }

// Relative to the modern constant.
real cook_torrance_scale(int variant) {
  if (variant == 2) return REAL(4.0) / BRDF_PI;
  if (variant >= 3) return REAL(4.0);
  return REAL(1.0);
}

// f0_or_ior as the variant says.
real cook_torrance_fresnel(int variant, real f0_or_ior, BrdfHalf h) {
  if (!cook_torrance_is_exact(variant)) return brdf_schlick(f0_or_ior, h.loss);
  return brdf_fresnel_exact((f0_or_ior - REAL(1.0)) * (f0_or_ior + REAL(1.0)), min(h.oh, REAL(1.0)));
}

real cook_torrance_eval(int variant, real ks, real m, real f0_or_ior, vec3 wi, vec3 wo) {
  BrdfHalf h = brdf_half(wi, wo);
  real e = ward_falloff(m, m, h);
  real r = REAL(1.0) / h.z2;
  // D G / oz: (1 + tan^2)^2 min(1 / oz, 2 hz / oh min(1, iz / oz)) with hz / oh = 2 Sz / S^2
  real groove = min(h.s2 / h.oz, REAL(4.0) * h.z * min(h.iz / h.oz, REAL(1.0)));
  real scale = ks * cook_torrance_scale(variant) / (REAL(4.0) * BRDF_PI * m * m);
  return scale * cook_torrance_fresnel(variant, f0_or_ior, h) * ((e * r) * (h.s2 * r)) * groove;
}

real cook_torrance_pdf(real m, vec3 wi, vec3 wo) { return ward_pdf(m, m, wi, wo); }

bool cook_torrance_sample(int variant, real ks, real m, real f0_or_ior, vec3 wo, vec2 u, OUT(vec3) wi, OUT(real) pdf,
                          OUT(real) weight) {
  wi = ward_direction(m, m, wo, u);
  pdf = cook_torrance_pdf(m, wi, wo);
  BrdfHalf h = brdf_half(wi, wo);
  // G oh / (oz hz), at most 2 because of the groove
  real groove = min(h.s2 / (REAL(2.0) * h.z * h.oz), REAL(2.0) * min(h.iz / h.oz, REAL(1.0)));
  weight = ks * cook_torrance_scale(variant) * cook_torrance_fresnel(variant, f0_or_ior, h) * groove;
  return wi.z > REAL(0.0);
}

#endif
