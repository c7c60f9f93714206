// Lambert 1760: f = rho / pi. rho in [0,1], the albedo exactly. The same brightness from everywhere: no sheen, no
// flattening of rough cloth.
#ifndef LAMBERT_GLSL
#define LAMBERT_GLSL
#include "shaders/brdf/brdf_common.glsl"

real lambert_eval(real rho, vec3 wi) { return rho / BRDF_PI * max(wi.z, REAL(0.0)); }

real lambert_pdf(vec3 wi) { return max(wi.z, REAL(0.0)) / BRDF_PI; }

bool lambert_sample(real rho, vec2 u, OUT(vec3) wi, OUT(real) pdf, OUT(real) weight) {
  wi = brdf_cosine_direction(u);
  pdf = lambert_pdf(wi);
  weight = rho;
  return true;
}

#endif
