#version 460
// Every function of shaders/brdf called once: compiled by the build for several LOBE_MODELS.
#extension GL_GOOGLE_include_directive : require
layout(local_size_x = 64) in;

#ifndef LOBE_MODELS
layout(constant_id = 0) const uint kModels = 2047u;
#define LOBE_MODELS kModels
#endif
#include "shaders/brdf/lobe.glsl"
#include "shaders/brdf/models.glsl"

// Every row of four words is full.
struct Probe {
  vec3 wi;
  uint tag;
  vec3 wo;
  int model;
  vec4 k;
  int variant;
  float p0, p1, p2, p3, p4, p5;
  float u0, u1;
  float lobe, value, density;
  vec3 drawn;
  int valid;
  float pdf, weight;
  float unused0, unused1;
};
layout(std430, binding = 0) buffer Probes { Probe probes[]; };

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= probes.length()) return;
  Probe p = probes[i];
  BrdfParams b = BrdfParams(p.model, p.variant, p.p0, p.p1, p.p2, p.p3, p.p4, p.p5);
  probes[i].lobe = lobe_eval(p.tag, p.k, p.wi, p.wo);
  probes[i].value = brdf_eval(b, p.wi, p.wo);
  probes[i].density = brdf_pdf(b, p.wi, p.wo);
  vec3 drawn;
  float pdf, weight;
  bool valid = brdf_sample(b, p.wo, vec2(p.u0, p.u1), drawn, pdf, weight);
  probes[i].drawn = drawn;
  probes[i].pdf = pdf;
  probes[i].weight = weight;
  probes[i].valid = valid ? 1 : 0;
}
