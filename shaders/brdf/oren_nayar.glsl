// Oren and Nayar 1994, "Generalization of Lambert's reflectance model". rho in [0,1]; sigma in [0, pi/2], the standard
// deviation of the facets' slope angle in radians.
// Variants: 0 qualitative, 1 full (three direct terms and interreflection).
// Cannot: conserve energy. The albedo reaches 1.015 (qualitative) and 1.048 (full) at grazing for small sigma, and the
// full model may be slightly negative. At sigma = 0 both are Lambert's bits.
#ifndef OREN_NAYAR_GLSL
#define OREN_NAYAR_GLSL
#include "shaders/brdf/brdf_common.glsl"

// sin a tan b cos(dphi) of the paper is d / max(iz, oz), d = ix ox + iy oy: no angles. Times the cosine it stays finite
// where both directions graze; there a d near 0 counts a million times, so it must not cancel.
real oren_nayar_qualitative(real a, real b, vec3 wi, vec3 wo) {
  real iz = max(wi.z, REAL(0.0));
  real d = max(brdf_sum_of_products(wi.x, wo.x, wi.y, wo.y), REAL(0.0));
  return a * iz + b * (d * (iz / max(iz, max(wo.z, BRDF_MIN_COS))));
}

// c1, c2, c3, c4: the factors that depend on sigma and rho alone, (2 / pi)^4 inside c3; see oren_nayar_eval. Returns
// fcos * pi / rho.
real oren_nayar_full(real c1, real c2, real c3, real c4, vec3 wi, vec3 wo) {
  real iz = max(wi.z, REAL(0.0));
  real oz = max(wo.z, BRDF_MIN_COS);
  real si = sqrt(wi.x * wi.x + wi.y * wi.y);
  real so = sqrt(wo.x * wo.x + wo.y * wo.y);
  // Azimuths mean nothing near the normal: there cos(dphi) counts as 0. 1 - |cos(dphi)| by the sine: it does not cancel.
  real ss = si * so;
  real d = wi.x * wo.x + wi.y * wo.y;
  real cross = wi.x * wo.y - wi.y * wo.x;
  bool defined = ss > REAL(1e-12);
  real inv_ss = REAL(1.0) / max(ss, REAL(1e-12));
  real cos_dphi = SELECT(defined, clamp(d * inv_ss, REAL(-1.0), REAL(1.0)), REAL(0.0));
  real rest = SELECT(defined, (cross * inv_ss) * (cross * inv_ss) / (REAL(1.0) + abs(cos_dphi)), REAL(1.0));
  // alpha is the larger angle, beta the smaller; delta = 1 - 2 beta / pi, small where both graze.
  real sa = max(si, so);
  real ca = min(iz, oz);
  real sb = min(si, so);
  real cb = max(iz, oz);
  real alpha = brdf_angle(sa, ca);
  real delta = brdf_angle(cb, sb) * (REAL(2.0) / BRDF_PI);
  real b2 = REAL(1.0) - delta;
  real beta = b2 * (BRDF_PI / REAL(2.0));
  // sin(alpha) - (2 beta / pi)^3, both near 1 at grazing
  real backward = delta * (REAL(3.0) - delta * (REAL(3.0) - delta)) - ca * ca / (REAL(1.0) + sa);
  real term2 = c2 * cos_dphi * SELECT(cos_dphi < REAL(0.0), backward, sa);
  real ab = alpha * beta;
  real term3 = c3 * rest * ab * ab;
  // iz tan(beta) and iz tan((alpha + beta) / 2), finite at the horizon
  real tan_beta = iz / cb * sb;
  real tan_mean = iz / (iz + oz) * (si + so);
  return iz * c1 + term2 * tan_beta + term3 * tan_mean + c4 * iz * (REAL(1.0) - cos_dphi * b2 * b2);
}

real oren_nayar_eval(int variant, real rho, real sigma, vec3 wi, vec3 wo) {
  real s2 = sigma * sigma;
  real c1 = REAL(1.0) - REAL(0.5) * s2 / (s2 + REAL(0.33));
  real c2 = REAL(0.45) * s2 / (s2 + REAL(0.09));
  if (variant == 0) return rho / BRDF_PI * oren_nayar_qualitative(c1, c2, wi, wo);
  // 0.125 (4 / pi^2)^2
  real c3 = REAL(0.0205319645) * s2 / (s2 + REAL(0.09));
  real c4 = REAL(0.17) * rho * s2 / (s2 + REAL(0.13));
  return rho / BRDF_PI * oren_nayar_full(c1, c2, c3, c4, wi, wo);
}

real oren_nayar_pdf(vec3 wi) { return max(wi.z, REAL(0.0)) / BRDF_PI; }

bool oren_nayar_sample(int variant, real rho, real sigma, vec3 wo, vec2 u, OUT(vec3) wi, OUT(real) pdf,
                       OUT(real) weight) {
  wi = brdf_cosine_direction(u);
  pdf = oren_nayar_pdf(wi);
  weight = oren_nayar_eval(variant, rho, sigma, wi, wo) / pdf;
  return true;
}

#endif
