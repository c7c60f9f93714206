// Lafortune et al. 1997, "Non-linear approximation of reflectance functions", one lobe:
// f = ks (cx ix ox + cy iy oy + cz iz oz)^n where the sum is positive, else 0. cx = cy = -1, cz = 1 mirrors, all
// positive sends light back, cx != cy is anisotropic, a small cz leans the lobe. n in [0, 2e4].
// Variants: 0 raw; 1 normalized, times (n + 2) / 2 pi and with C divided by its largest component (Ngan et al. 2005):
// albedo at most 1. Raw fits such as C = 0.577, n = 4060 have a peak of 1e-970 without it.
// Cannot: brighten towards grazing; the albedo of the mirroring lobe falls like the cosine.
#ifndef LAFORTUNE_GLSL
#define LAFORTUNE_GLSL
#include "shaders/brdf/brdf_common.glsl"

real lafortune_max(real cx, real cy, real cz) { return max(max(abs(cx), abs(cy)), abs(cz)); }

// t L - sum of c_k i_k o_k, where t is the largest |c_k| and L the mean of the vectors' squared lengths: as a sum of
// t (i -+ o)^2 / 2 +- (t - |c|) i o over the components, which does not cancel at the peak and divides nothing.
real lafortune_distance(real t, real cx, real cy, real cz, vec3 wi, vec3 wo) {
  vec3 s = vec3(SELECT(cx < REAL(0.0), REAL(-1.0), REAL(1.0)), SELECT(cy < REAL(0.0), REAL(-1.0), REAL(1.0)),
                SELECT(cz < REAL(0.0), REAL(-1.0), REAL(1.0)));
  vec3 o = vec3(s.x * wo.x, s.y * wo.y, s.z * wo.z);
  vec3 d = vec3(wi.x - o.x, wi.y - o.y, wi.z - o.z);
  real rest = (t - abs(cx)) * (wi.x * o.x) + (t - abs(cy)) * (wi.y * o.y) + (t - abs(cz)) * (wi.z * o.z);
  return REAL(0.5) * t * (d.x * d.x + d.y * d.y + d.z * d.z) + rest;
}

// The n-th power of t 2^-q, normalised or raw. A raw peak t^n belongs to the exponent: alone it under- or overflows.
real lafortune_power(int variant, real n, real t, real q) {
  if (variant == 1) return (n + REAL(2.0)) / (REAL(2.0) * BRDF_PI) * brdf_falloff(n * q);
  real exponent = n * (q - brdf_log2(t));
  real value = brdf_exp2(clamp(-exponent, -BRDF_MAX_EXPONENT, BRDF_MAX_EXPONENT));
  return SELECT(exponent < BRDF_MAX_EXPONENT, value, REAL(0.0));
}

real lafortune_eval(int variant, real ks, real cx, real cy, real cz, real n, vec3 wi, vec3 wo) {
  real t = lafortune_max(cx, cy, cz);
  real x = brdf_sum_of_triple_products(vec3(cx, cy, cz), wo, wi);
  if (x <= REAL(0.0)) return REAL(0.0);
  // -log2 of x / t, relative to the vectors' squared length
  real q = brdf_log2_ratio(lafortune_distance(t, cx, cy, cz, wi, wo), x);
  return ks * lafortune_power(variant, n, t, q) * max(wi.z, REAL(0.0));
}

// The same at the lobe's axis w: fcos / pdf without the cosine and the sampler's norm. 1 - |w|^2 / t^2 as a sum of
// positive terms.
real lafortune_peak(int variant, real ks, real cx, real cy, real cz, real n, vec3 wo) {
  real t = lafortune_max(cx, cy, cz);
  vec3 o = vec3(wo.x * wo.x, wo.y * wo.y, wo.z * wo.z);
  real rest = (t - abs(cx)) * (t + abs(cx)) * o.x + (t - abs(cy)) * (t + abs(cy)) * o.y + (t - abs(cz)) * (t + abs(cz)) * o.z;
  real length2 = max(cx * cx * o.x + cy * cy * o.y + cz * cz * o.z, REAL(1e-30));
  return ks * lafortune_power(variant, n, t, REAL(0.5) * brdf_log2_ratio(rest, length2));
}

// C wo, with the largest of C as 1.
vec3 lafortune_axis(real cx, real cy, real cz, vec3 wo) {
  real t = max(lafortune_max(cx, cy, cz), REAL(1e-30));
  return vec3(cx / t * wo.x, cy / t * wo.y, cz / t * wo.z);
}

// A power of a cosine about that axis; the plain cosine where w vanishes.
real lafortune_pdf(real cx, real cy, real cz, real n, vec3 wi, vec3 wo) {
  vec3 w = lafortune_axis(cx, cy, cz, wo);
  real length_w = sqrt(dot(w, w));
  if (length_w < REAL(1e-6)) return max(wi.z, REAL(0.0)) / BRDF_PI;
  vec3 axis = vec3(w.x / length_w, w.y / length_w, w.z / length_w);
  vec3 d = vec3(wi.x - axis.x, wi.y - axis.y, wi.z - axis.z);
  real c = dot(wi, axis);
  real power = brdf_falloff(n * brdf_log2_ratio(REAL(0.5) * dot(d, d), max(c, REAL(1e-30))));
  return SELECT(c > REAL(0.0), (n + REAL(1.0)) / (REAL(2.0) * BRDF_PI) * power, REAL(0.0));
}

bool lafortune_sample(int variant, real ks, real cx, real cy, real cz, real n, vec3 wo, vec2 u, OUT(vec3) wi,
                      OUT(real) pdf, OUT(real) weight) {
  vec3 w = lafortune_axis(cx, cy, cz, wo);
  real length_w = sqrt(dot(w, w));
  if (length_w < REAL(1e-6)) {
    wi = brdf_cosine_direction(u);
  } else {
    // A frame about the axis (Duff et al. 2017) and the power cosine in it.
    vec3 axis = vec3(w.x / length_w, w.y / length_w, w.z / length_w);
    real side = SELECT(axis.z < REAL(0.0), REAL(-1.0), REAL(1.0));
    real a = REAL(-1.0) / (side + axis.z);
    real b = axis.x * axis.y * a;
    vec3 t1 = vec3(REAL(1.0) + side * axis.x * axis.x * a, side * b, -side * axis.x);
    vec3 t2 = vec3(b, side + axis.y * axis.y * a, -axis.y);
    real tan2 = brdf_expm1(REAL(2.0) * brdf_minus_log1m(u.y) / (n + REAL(1.0)));
    real cosine = REAL(1.0) / sqrt(REAL(1.0) + tan2);
    vec2 c = brdf_unit_circle(u.x);
    real x = cosine * sqrt(tan2) * c.x;
    real y = cosine * sqrt(tan2) * c.y;
    wi = vec3(x * t1.x + y * t2.x + cosine * axis.x, x * t1.y + y * t2.y + cosine * axis.y,
              x * t1.z + y * t2.z + cosine * axis.z);
  }
  pdf = lafortune_pdf(cx, cy, cz, n, wi, wo);
  if (length_w < REAL(1e-6)) {
    weight = lafortune_eval(variant, ks, cx, cy, cz, n, wi, wo) / max(pdf, REAL(1e-37));
  } else {
    weight = lafortune_peak(variant, ks, cx, cy, cz, n, wo) * REAL(2.0) * BRDF_PI / (n + REAL(1.0)) * max(wi.z, REAL(0.0));
  }
  return wi.z > REAL(0.0) && pdf > REAL(0.0);
}

#endif
