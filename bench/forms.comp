#version 460
// One form of one model, evaluated many times: what an evaluation costs, and what the textbook form answers.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "shaders/shared/probe.h"
#include "bench/forms_shared.h"

layout(local_size_x = PROBE_GROUP_SIZE) in;
layout(constant_id = SPEC_FORM) const uint FORM = FORM_NONE;
layout(constant_id = SPEC_FORM_MODEL) const int MODEL = 0;
layout(constant_id = SPEC_FORM_VARIANT) const int VARIANT = 0;
layout(constant_id = SPEC_FORM_REPEATS) const uint REPEATS = 1;
layout(constant_id = SPEC_FORM_MODELS) const uint MODELS = ~0u;
#define LOBE_MODELS MODELS
#include "shaders/brdf/lobe.glsl"
#include "shaders/brdf/models.glsl"
#include "bench/textbook/textbook.glsl"

layout(scalar, binding = BINDING_QUESTIONS) readonly buffer Questions { Question questions[]; };
layout(scalar, binding = BINDING_ANSWERS) writeonly buffer Answers { Answer answers[]; };
layout(push_constant) uniform Push { uint count; };

void main() {
  uint i = gl_GlobalInvocationID.x;
  if (i >= count) return;
  Question q = questions[i];
  BrdfParams b = BrdfParams(MODEL, VARIANT, q.p0, q.p1, q.p2, q.p3, q.p4, q.p5);
  float sum = 0.0;
  for (uint k = 0u; k < REPEATS; ++k) {
    // Another light each time, near enough that it stays in the same region; the first is the question's own.
    vec3 wi = q.wi + float(k) * vec3(1e-6, -2e-6, 1e-6);
    float value = wi.x + wi.y * wi.z;
    if (FORM == FORM_ROBUST) value = brdf_eval(b, wi, q.wo);
    if (FORM == FORM_TEXTBOOK) value = textbook_eval(MODEL, VARIANT, q.p0, q.p1, q.p2, q.p3, q.p4, wi, q.wo);
    if (FORM == FORM_LOBE) value = lobe_eval(q.tag, vec4(q.k0, q.k1, q.k2, q.k3), wi, q.wo);
    sum += value;
  }
  answers[i] = Answer(sum, 0.0, vec3(0.0), 0u);
}
