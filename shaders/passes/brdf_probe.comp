#version 460
// The BRDFs by themselves, one question an invocation: `vamp brdf`, measurements and tests. No cuts beyond the models' own.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shaders/shared/probe.h"

layout(local_size_x = PROBE_GROUP_SIZE) in;
layout(constant_id = SPEC_PROBE_WORK) const uint WORK = PROBE_EVAL;
layout(constant_id = SPEC_PROBE_MODELS) const uint MODELS = ~0u;
#define LOBE_MODELS MODELS
#include "shaders/brdf/lobe.glsl"
#include "shaders/brdf/models.glsl"

layout(scalar, binding = BINDING_QUESTIONS) readonly buffer Questions { Question questions[]; };
layout(scalar, binding = BINDING_ANSWERS) writeonly buffer Answers { Answer answers[]; };
layout(push_constant) uniform Push { uint count; };

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= count) return;
  Question q = questions[i];
  BrdfParams b = BrdfParams(int(q.model), int(q.variant), q.p0, q.p1, q.p2, q.p3, q.p4, q.p5);
  Answer a = Answer(0.0, 0.0, vec3(0.0), 0u);
  if (WORK == PROBE_EVAL) {
    a.value = brdf_eval(b, q.wi, q.wo);
    a.pdf = brdf_pdf(b, q.wi, q.wo);
  } else if (WORK == PROBE_LOBE) {
    a.value = lobe_eval(q.tag, vec4(q.k0, q.k1, q.k2, q.k3), q.wi, q.wo);
  } else {
    a.valid = brdf_sample(b, q.wo, vec2(q.u0, q.u1), a.wi, a.pdf, a.value) ? 1u : 0u;
  }
  answers[i] = a;
}
