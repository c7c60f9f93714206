// Ashikhmin and Shirley 2000, "An anisotropic Phong BRDF model". rs, the reflectance head-on, and rd, the base's, in
// [0,1]; nu, nv in [0, 1e5]: exponents along x and y.
// Variants: 0 specular, 1 diffuse (the base as the coat leaves it), 2 full, their sum.
// Cannot: reach a mirror's brightness at grazing, where its albedo tends to 1/2.
#ifndef ASHIKHMIN_SHIRLEY_GLSL
#define ASHIKHMIN_SHIRLEY_GLSL
#include "shaders/brdf/brdf_common.glsl"

// 1 - (1 - c / 2)^5, multiplied out: it does not cancel where c is small.
real ashikhmin_shirley_fade(real c) {
  real x = REAL(0.5) * c;
  return x * (REAL(5.0) - x * (REAL(10.0) - x * (REAL(10.0) - x * (REAL(5.0) - x))));
}

// h.z^E, E = (nu hx^2 + nv hy^2) / (1 - h.z^2), by logarithm; where S is the normal both factors of q vanish.
real ashikhmin_shirley_power(real nu, real nv, BrdfHalf h) {
  real exponent = (nu * h.x2 + nv * h.y2) / max(h.x2 + h.y2, REAL(1e-30));
  return brdf_falloff(REAL(0.5) * exponent * brdf_log2_secant2(h));
}

real ashikhmin_shirley_eval(int variant, real rs, real rd, real nu, real nv, vec3 wi, vec3 wo) {
  BrdfHalf h = brdf_half(wi, wo);
  real value = REAL(0.0);
  if (variant != 1) {
    real norm = sqrt((nu + REAL(1.0)) * (nv + REAL(1.0))) / (REAL(8.0) * BRDF_PI);
    real cosines = min(h.iz / h.oz, REAL(1.0)) / max(h.oh, REAL(1e-12));  // iz / max(iz, oz) / oh
    value = norm * ashikhmin_shirley_power(nu, nv, h) * brdf_schlick(rs, h.loss) * cosines;
  }
  if (variant != 0) {
    value += REAL(28.0) / (REAL(23.0) * BRDF_PI) * rd * (REAL(1.0) - rs) * ashikhmin_shirley_fade(h.iz) *
             ashikhmin_shirley_fade(h.oz) * h.iz;
  }
  return value;
}

real ashikhmin_shirley_specular_pdf(real nu, real nv, vec3 wi, vec3 wo) {
  BrdfHalf h = brdf_half(wi, wo);
  real norm = sqrt((nu + REAL(1.0)) * (nv + REAL(1.0))) / (REAL(8.0) * BRDF_PI);
  return norm * ashikhmin_shirley_power(nu, nv, h) / max(h.oh, REAL(1e-12));
}

// The full model draws from its two parts with equal chances.
real ashikhmin_shirley_pdf(int variant, real nu, real nv, vec3 wi, vec3 wo) {
  real cosine = max(wi.z, REAL(0.0)) / BRDF_PI;
  if (variant == 1) return cosine;
  real specular = ashikhmin_shirley_specular_pdf(nu, nv, wi, wo);
  return SELECT(variant == 0, specular, REAL(0.5) * (specular + cosine));
}

bool ashikhmin_shirley_sample(int variant, real rs, real rd, real nu, real nv, vec3 wo, vec2 u, OUT(vec3) wi,
                              OUT(real) pdf, OUT(real) weight) {
  bool base = variant == 1 || (variant == 2 && u.y < REAL(0.5));
  real v = SELECT(variant == 2, REAL(2.0) * u.y - SELECT(base, REAL(0.0), REAL(1.0)), u.y);
  if (base) {
    wi = brdf_cosine_direction(vec2(v, u.x));
  } else {
    vec2 c = brdf_unit_circle(u.x);
    real x = sqrt(nv + REAL(1.0)) * c.x;
    real y = sqrt(nu + REAL(1.0)) * c.y;
    real r2 = x * x + y * y;
    real exponent = (nu * (x * x) + nv * (y * y)) / r2;
    real tangent = sqrt(brdf_expm1(REAL(2.0) * brdf_minus_log1m(v) / (exponent + REAL(1.0))) / r2);
    wi = brdf_mirror(wo, tangent * x, tangent * y);
  }
  pdf = ashikhmin_shirley_pdf(variant, nu, nv, wi, wo);
  BrdfHalf h = brdf_half(wi, wo);
  weight = brdf_schlick(rs, h.loss) * min(h.iz / h.oz, REAL(1.0));
  if (variant != 0) weight = ashikhmin_shirley_eval(variant, rs, rd, nu, nv, wi, wo) / max(pdf, REAL(1e-37));
  return wi.z > REAL(0.0);
}

#endif
