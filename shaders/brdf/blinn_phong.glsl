// Blinn 1977, "Models of light reflection for computer synthesized pictures": f = ks c(n) (n.h)^n, n in [0, 131071].
// Variants, by c: 0 raw, 1; 1 normalized, exactly albedo 1 at normal incidence and never more
// (Giesen 2009, "Phong and Blinn-Phong normalization factors"); 2 (n + 2) / 2 pi, the norm of another lobe, up to four
// times too bright; 3 (n + 8) / 8 pi, albedo up to 1.075 near n = 10.
// Cannot: keep its energy at an angle; without 1 / cos factors the albedo falls to a quarter at 60 degrees.
#ifndef BLINN_PHONG_GLSL
#define BLINN_PHONG_GLSL
#include "shaders/brdf/brdf_common.glsl"

real blinn_phong_norm(int variant, real n) {
  if (variant == 0) return REAL(1.0);
  if (variant == 2) return (n + REAL(2.0)) / (REAL(2.0) * BRDF_PI);
  if (variant == 3) return (n + REAL(8.0)) / (REAL(8.0) * BRDF_PI);
  return (n + REAL(2.0)) * (n + REAL(4.0)) / (REAL(8.0) * BRDF_PI * (brdf_falloff(REAL(0.5) * n) + n));
}

real blinn_phong_eval(int variant, real ks, real n, vec3 wi, vec3 wo) {
  BrdfHalf h = brdf_half(wi, wo);
  return ks * blinn_phong_norm(variant, n) * brdf_falloff(REAL(0.5) * n * brdf_log2_secant2(h)) * h.iz;
}

real blinn_phong_pdf(real n, vec3 wi, vec3 wo) {
  BrdfHalf h = brdf_half(wi, wo);
  real power = brdf_falloff(REAL(0.5) * n * brdf_log2_secant2(h));
  return (n + REAL(1.0)) / (REAL(8.0) * BRDF_PI * h.oh) * power;
}

// cos(theta_h) = (1 - u)^(1 / (n + 1)), through tan^2 so that nothing cancels.
bool blinn_phong_sample(int variant, real ks, real n, vec3 wo, vec2 u, OUT(vec3) wi, OUT(real) pdf, OUT(real) weight) {
  real tangent = sqrt(brdf_expm1(REAL(2.0) * brdf_minus_log1m(u.y) / (n + REAL(1.0))));
  vec2 c = brdf_unit_circle(u.x);
  wi = brdf_mirror(wo, tangent * c.x, tangent * c.y);
  pdf = blinn_phong_pdf(n, wi, wo);
  BrdfHalf h = brdf_half(wi, wo);
  weight = ks * blinn_phong_norm(variant, n) * h.iz * h.oh * (REAL(8.0) * BRDF_PI / (n + REAL(1.0)));
  return wi.z > REAL(0.0);
}

#endif
