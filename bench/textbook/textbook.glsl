// The models as papers and textbooks write them down: a normalised half vector, pow, exp. What the forms of shaders/brdf
// are measured against; no picture is made with it but those of `vamp bench shading`. GLSL and C++ like those (shaders/brdf/brdf_common.glsl), the usual
// forms in float as they stand in renderers: angles only where there is no way round them.
#ifndef TEXTBOOK_GLSL
#define TEXTBOOK_GLSL
#include "shaders/brdf/brdf_common.glsl"

real textbook_schlick(real f0, real c) { return f0 + (REAL(1.0) - f0) * pow(max(REAL(1.0) - c, REAL(0.0)), REAL(5.0)); }

real textbook_fresnel(real ior, real c) {
  real g = sqrt(max(ior * ior - REAL(1.0) + c * c, REAL(0.0)));
  real a = (g - c) / (g + c);
  real b = (c * (g + c) - REAL(1.0)) / (c * (g - c) + REAL(1.0));
  return REAL(0.5) * a * a * (REAL(1.0) + b * b);
}

real textbook_cos_dphi(vec3 wi, vec3 wo, real si, real so) {
  real ss = si * so;
  return SELECT(ss > REAL(1e-6), clamp((wi.x * wo.x + wi.y * wo.y) / max(ss, REAL(1e-6)), REAL(-1.0), REAL(1.0)), REAL(0.0));
}

// Sines and tangents from cosines, as in pbrt (Pharr et al. 2016, 8.4.1). Times pi / rho, with A and B at hand.
real textbook_oren_nayar(real a, real b, vec3 wi, vec3 wo) {
  real si = sqrt(max(REAL(1.0) - wi.z * wi.z, REAL(0.0)));
  real so = sqrt(max(REAL(1.0) - wo.z * wo.z, REAL(0.0)));
  bool steeper = wi.z > wo.z;
  real sin_alpha = SELECT(steeper, so, si);
  real tan_beta = SELECT(steeper, si / wi.z, so / wo.z);
  return wi.z * (a + b * max(textbook_cos_dphi(wi, wo, si, so), REAL(0.0)) * sin_alpha * tan_beta);
}

// c1 to c4 as oren_nayar_full() takes them.
real textbook_oren_nayar_full(real c1, real c2, real c3, real c4, vec3 wi, vec3 wo) {
  real ti = acos(wi.z);
  real to = acos(wo.z);
  real alpha = max(ti, to);
  real beta = min(ti, to);
  real b2 = REAL(2.0) * beta / BRDF_PI;
  real c = textbook_cos_dphi(wi, wo, sin(ti), sin(to));
  real term2 = c2 * (sin(alpha) - SELECT(c >= REAL(0.0), REAL(0.0), pow(b2, REAL(3.0))));
  real ab = alpha * beta;
  return wi.z * (c1 + c * term2 * tan(beta) + (REAL(1.0) - abs(c)) * c3 * ab * ab * tan(REAL(0.5) * (alpha + beta)) +
                 c4 * (REAL(1.0) - c * b2 * b2));
}

real textbook_blinn_phong(real n, vec3 h) { return pow(h.z, n); }

// exp(-tan^2 cos^2 phi / ax^2 ..), of widths as 1 / alpha^2.
real textbook_gauss(real inv_ax2, real inv_ay2, vec3 h) {
  return exp(-(h.x * h.x * inv_ax2 + h.y * h.y * inv_ay2) / (h.z * h.z));
}

// Beckmann's D without 1 / (pi m^2), times G / (iz oz).
real textbook_cook_torrance(real inv_m2, vec3 h, real oh, real iz, real oz) {
  real z2 = h.z * h.z;
  real d = exp((z2 - REAL(1.0)) / z2 * inv_m2) / (z2 * z2);
  real g = min(REAL(1.0), min(REAL(2.0) * h.z * oz / oh, REAL(2.0) * h.z * iz / oh));
  return d * g / (iz * oz);
}

// 0 / 0 at the normal itself, as printed.
real textbook_ashikhmin_shirley(real nu, real nv, vec3 h, real oh, real iz, real oz) {
  real exponent = (nu * h.x * h.x + nv * h.y * h.y) / (REAL(1.0) - h.z * h.z);
  return pow(h.z, exponent) / (oh * max(iz, oz));
}

real textbook_ashikhmin_shirley_base(real iz, real oz) {
  return (REAL(1.0) - pow(REAL(1.0) - REAL(0.5) * iz, REAL(5.0))) * (REAL(1.0) - pow(REAL(1.0) - REAL(0.5) * oz, REAL(5.0)));
}

// fcos of any model by its number and parameters in the papers' order.
real textbook_eval(int model, int variant, real p0, real p1, real p2, real p3, real p4, vec3 wi, vec3 wo) {
  real iz = wi.z;
  real oz = wo.z;
  if (model == 0) return p0 / BRDF_PI * iz;
  if (model == 1) {
    real s2 = p1 * p1;
    real c1 = REAL(1.0) - REAL(0.5) * s2 / (s2 + REAL(0.33));
    real c2 = REAL(0.45) * s2 / (s2 + REAL(0.09));
    if (variant == 0) return p0 / BRDF_PI * textbook_oren_nayar(c1, c2, wi, wo);
    real c3 = REAL(0.125) * s2 / (s2 + REAL(0.09)) * REAL(16.0) / (BRDF_PI * BRDF_PI * BRDF_PI * BRDF_PI);
    real c4 = REAL(0.17) * p0 * s2 / (s2 + REAL(0.13));
    return p0 / BRDF_PI * textbook_oren_nayar_full(c1, c2, c3, c4, wi, wo);
  }
  vec3 h = normalize(vec3(wi.x + wo.x, wi.y + wo.y, wi.z + wo.z));
  real oh = dot(wo, h);
  if (model == 2) {
    real norm = REAL(1.0);
    if (variant == 1) norm = (p1 + REAL(2.0)) * (p1 + REAL(4.0)) / (REAL(8.0) * BRDF_PI * (pow(REAL(2.0), REAL(-0.5) * p1) + p1));
    if (variant == 2) norm = (p1 + REAL(2.0)) / (REAL(2.0) * BRDF_PI);
    if (variant == 3) norm = (p1 + REAL(8.0)) / (REAL(8.0) * BRDF_PI);
    return p0 * norm * textbook_blinn_phong(p1, h) * iz;
  }
  if (model == 3) {
    real k = p0 / (REAL(4.0) * BRDF_PI * p1 * p2) * textbook_gauss(REAL(1.0) / (p1 * p1), REAL(1.0) / (p2 * p2), h);
    if (variant == 1) return k / sqrt(iz * oz) * iz;
    if (variant == 2) return k / (iz * oz) * iz;
    return k / (oh * oh * pow(h.z, REAL(4.0))) * iz;
  }
  if (model == 4) {
    bool exact = variant == 1 || variant == 4;
    real scale = REAL(1.0);
    if (variant == 2) scale = REAL(4.0) / BRDF_PI;
    if (variant >= 3) scale = REAL(4.0);
    real f = REAL(0.0);
    if (exact) f = textbook_fresnel(p2, oh);
    if (!exact) f = textbook_schlick(p2, oh);
    return p0 * scale / (REAL(4.0) * BRDF_PI * p1 * p1) * f * textbook_cook_torrance(REAL(1.0) / (p1 * p1), h, oh, iz, oz) * iz;
  }
  if (model == 5) {
    real sum = p1 * wi.x * wo.x + p2 * wi.y * wo.y + p3 * wi.z * wo.z;
    real norm = REAL(1.0);
    if (variant == 1) {
      sum = sum / max(max(abs(p1), abs(p2)), abs(p3));
      norm = (p4 + REAL(2.0)) / (REAL(2.0) * BRDF_PI);
    }
    return p0 * norm * pow(max(sum, REAL(0.0)), p4) * iz;
  }
  real value = REAL(0.0);
  if (variant != 1)
    value = sqrt((p2 + REAL(1.0)) * (p3 + REAL(1.0))) / (REAL(8.0) * BRDF_PI) * textbook_schlick(p0, oh) *
            textbook_ashikhmin_shirley(p2, p3, h, oh, iz, oz);
  if (variant != 0)
    value += REAL(28.0) / (REAL(23.0) * BRDF_PI) * p1 * (REAL(1.0) - p0) * textbook_ashikhmin_shirley_base(iz, oz);
  return value * iz;
}

#endif
