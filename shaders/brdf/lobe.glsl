// One code for all seven models: what the shading kernel evaluates for each basis. The value is fcos without the factor
// that does not depend on directions (PackedLobe::scale, multiplied into the RGB gain on the CPU), with SPMM's cuts and
// windows for a tilted local frame:
//   - a light at or below the local horizon gives 0;
//   - a viewer below it cuts every highlight, through a window of 0.03 in the cosine so that no line shows; Lambert and
//     Oren-Nayar are not cut.
//
// On a CPU device every branch of a kernel runs for all lanes, so the models differ in selects and factors, not in
// branches: one 2^x, one logarithm, and a division for the exponent, one for the logarithm's argument, one for Fresnel's
// cosine and one for Ashikhmin-Shirley, of which a scene has those that its models need. The includer may define LOBE_MODELS,
// a constant or a specialisation constant of LOBE_* bits: code that no bit asks for is removed, and what remains gives
// the same bits. pack_lobe (engine/brdf/pack.cpp) makes `tag` and `k`:
//
//   path            k.x          k.y          k.z     k.w            value
//   diffuse         A            B                                   A iz + B d iz / max(iz, oz)
//   Oren-Nayar full c1           c2           c3      c4             see oren_nayar.glsl
//   Blinn-Phong     n / 2        n / 2        1                      2^-q iz
//   Ward            log2e / ax^2 log2e / ay^2 1                      2^-q (S^2 / Sz^4) iz
//   Cook-Torrance   log2e / m^2  log2e / m^2  f0      ior^2 - 1      2^-q (S^2 / Sz^4) F min(S^2 / oz, 4 Sz min(iz / oz, 1))
//   Lafortune       cx           cy           cz      n              2^-q iz
//   Ashikhmin-Sh.   nu / 2       nv / 2       rs      base / scale   2^-q F min(iz / oz, 1) / oh + base
#ifndef LOBE_GLSL
#define LOBE_GLSL
#include "shaders/brdf/brdf_common.glsl"
#include "shaders/brdf/ashikhmin_shirley.glsl"
#include "shaders/brdf/lafortune.glsl"
#include "shaders/brdf/lobe_tags.h"
#include "shaders/brdf/oren_nayar.glsl"

#ifndef LOBE_MODELS
#define LOBE_MODELS LOBE_EVERYTHING
#endif
#define LOBE_NEEDS(bits) ((LOBE_MODELS & (bits)) != 0u)

// What does not depend on the light: once per basis and pixel.
struct LobeView {
  vec3 wo;
  real oz, inv_oz;
  real window;
  vec3 other;  // the viewer, of Lafortune's lobe with the signs of its constants
  // Of Lafortune's lobe: its sum is dot(axis, wi), lafortune_distance() is half_top |wi - other|^2 + dot(rest, wi).
  vec3 axis, rest;
  real half_top;
};

LobeView lobe_view(uint tag, vec4 k, vec3 wo) {
  LobeView v;
  v.wo = wo;
  v.oz = max(wo.z, REAL(1e-6));
  v.inv_oz = REAL(1.0) / v.oz;
  bool uncut = (tag & (LOBE_TAG_DIFFUSE | LOBE_TAG_FULL)) != 0u;
  v.window = SELECT(uncut, REAL(1.0), clamp(wo.z * REAL(33.3333333), REAL(0.0), REAL(1.0)));
  v.other = wo;
  if (LOBE_NEEDS(LOBE_LAFORTUNE)) {
    bool lafortune = (tag & LOBE_TAG_LAFORTUNE) != 0u;
    real top = lafortune_max(k.x, k.y, k.z);
    v.half_top = REAL(0.5) * top;
    v.axis = vec3(k.x * wo.x, k.y * wo.y, k.z * wo.z);
    v.other = vec3(SELECT(lafortune && k.x < REAL(0.0), -wo.x, wo.x), SELECT(lafortune && k.y < REAL(0.0), -wo.y, wo.y),
                   SELECT(lafortune && k.z < REAL(0.0), -wo.z, wo.z));
    v.rest = vec3((top - abs(k.x)) * v.other.x, (top - abs(k.y)) * v.other.y, (top - abs(k.z)) * v.other.z);
  }
  return v;
}

real lobe_eval_view(uint tag, vec4 k, vec3 wi, LobeView v) {
  real iz = max(wi.z, REAL(0.0));
  real ratio = min(iz, v.oz) * v.inv_oz;  // min(iz / oz, 1) = iz / max(iz, oz)
  real value = REAL(0.0);

  if (LOBE_NEEDS(LOBE_EVERYTHING & ~(LOBE_LAMBERT | LOBE_OREN_NAYAR | LOBE_OREN_NAYAR_FULL))) {
    bool power = (tag & LOBE_TAG_POWER) != 0u;
    bool lafortune = (tag & LOBE_TAG_LAFORTUNE) != 0u;
    real sx = wi.x + v.wo.x;
    real sy = wi.y + v.wo.y;
    real sz = iz + v.oz;
    real x2 = sx * sx;
    real y2 = sy * sy;
    real z2 = sz * sz;
    real p2 = x2 + y2;
    real s2 = max(p2 + z2, REAL(1e-8));
    vec3 d = vec3(wi.x - v.other.x, wi.y - v.other.y, wi.z - v.other.z);
    real d2 = d.x * d.x + d.y * d.y + d.z * d.z;

    // The exponent q in powers of two.
    real numerator = k.x * x2 + k.y * y2;
    real denominator = z2;
    real logarithm = REAL(1.0);
    if (LOBE_NEEDS(LOBE_BLINN_PHONG | LOBE_ASHIKHMIN_SHIRLEY | LOBE_LAFORTUNE)) {
      real a = p2;
      real b = z2;
      denominator = SELECT(power, max(p2, REAL(1e-30)), z2);
      if (LOBE_NEEDS(LOBE_LAFORTUNE)) {
        real x = v.axis.x * wi.x + v.axis.y * wi.y + v.axis.z * wi.z;
        real distance = v.half_top * d2 + (v.rest.x * wi.x + v.rest.y * wi.y + v.rest.z * wi.z);
        a = SELECT(lafortune, distance, p2);
        b = SELECT(lafortune, max(x, REAL(1e-30)), z2);
        numerator = SELECT(lafortune, SELECT(x > REAL(0.0), k.w, REAL(1e9)), numerator);
        denominator = SELECT(lafortune, REAL(1.0), denominator);
      }
      logarithm = SELECT(power || lafortune, brdf_log2_ratio(a, b), REAL(1.0));
    }
    real r = REAL(1.0) / denominator;
    real e = brdf_falloff(numerator * r * logarithm);

    // The geometric factor, cosine of the light included.
    real geometry = iz;
    if (LOBE_NEEDS(LOBE_COOK_TORRANCE)) {
      real groove = min(s2 * v.inv_oz, REAL(4.0) * sz * ratio);
      geometry = SELECT((tag & LOBE_TAG_GROOVE) != 0u, groove, geometry);
    }
    if (LOBE_NEEDS(LOBE_WARD_IMPORTED)) {
      geometry = SELECT((tag & LOBE_TAG_SQRT) != 0u, sqrt(iz * v.inv_oz), geometry);
      geometry = SELECT((tag & LOBE_TAG_DUER) != 0u, SELECT(iz > REAL(0.0), v.inv_oz, REAL(0.0)), geometry);
    }
    if (LOBE_NEEDS(LOBE_WARD | LOBE_COOK_TORRANCE)) {
      geometry = SELECT((tag & LOBE_TAG_WIDTH) != 0u, (e * r) * (s2 * r) * geometry, e * geometry);
    } else {
      geometry = e * geometry;
    }
    value = geometry;

    if (LOBE_NEEDS(LOBE_COOK_TORRANCE | LOBE_ASHIKHMIN_SHIRLEY | LOBE_FRESNEL_EXACT)) {
      real oh = REAL(0.5) * sqrt(s2);
      if (LOBE_NEEDS(LOBE_ASHIKHMIN_SHIRLEY)) {
        value = SELECT((tag & LOBE_TAG_MAXCOS) != 0u, e * (ratio / oh), value);
      }
      real f = brdf_schlick(k.z, REAL(0.25) * d2 / (REAL(1.0) + oh));  // brdf_cosine_loss()
      if (LOBE_NEEDS(LOBE_FRESNEL_EXACT)) {
        f = SELECT((tag & LOBE_TAG_EXACT) != 0u, brdf_fresnel_exact(k.w, min(oh, REAL(1.0))), f);
      }
      value = value * SELECT(lafortune, REAL(1.0), f);
    }
    if (LOBE_NEEDS(LOBE_ASHIKHMIN_SHIRLEY_BASE)) {
      value = SELECT((tag & LOBE_TAG_BASE_ONLY) != 0u, REAL(0.0), value);
      real base = k.w * ashikhmin_shirley_fade(iz) * ashikhmin_shirley_fade(v.oz) * iz;
      value = value + SELECT((tag & LOBE_TAG_MAXCOS) != 0u, base, REAL(0.0));
    }
    value = value * v.window;
  }

  if (LOBE_NEEDS(LOBE_LAMBERT | LOBE_OREN_NAYAR)) {
    real diffuse = k.x * iz;
    if (LOBE_NEEDS(LOBE_OREN_NAYAR)) {
      diffuse = diffuse + k.y * (max(wi.x * v.wo.x + wi.y * v.wo.y, REAL(0.0)) * ratio);
    }
    value = SELECT((tag & LOBE_TAG_DIFFUSE) != 0u, diffuse, value);
  }
  if (LOBE_NEEDS(LOBE_OREN_NAYAR_FULL)) {
    real full = oren_nayar_full(k.x, k.y, k.z, k.w, wi, v.wo);
    value = SELECT((tag & LOBE_TAG_FULL) != 0u, full, value);
  }
  PRECISE real result = value;
  return result;
}

real lobe_eval(uint tag, vec4 k, vec3 wi, vec3 wo) { return lobe_eval_view(tag, k, wi, lobe_view(tag, k, wo)); }

#endif
