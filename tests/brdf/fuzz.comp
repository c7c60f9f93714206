#version 460
// Any bits as directions: nothing that a shading kernel computes of them may be NaN, infinite, or negative where the model
// forbids it. What fails is stored.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "tests/brdf/fuzz.h"

layout(local_size_x = 64) in;
#include "shaders/brdf/lobe.glsl"
#include "shaders/brdf/models.glsl"

layout(scalar, binding = FUZZ_LOBES) readonly buffer Lobes { FuzzLobe lobes[]; };
layout(scalar, binding = FUZZ_FAILURES) buffer Failures { uint count; FuzzFailure failures[]; };
layout(push_constant) uniform Push { FuzzPush push; };

bool is_number(float x) { return (floatBitsToInt(x) & 0x7f800000) != 0x7f800000; }

void main() {
  uint index = push.first + gl_GlobalInvocationID.x;
  FuzzLobe lobe = lobes[index % push.lobes];
  FuzzCase c = fuzz_case(index, push.seed);
  FuzzFailure f = FuzzFailure(index, index % push.lobes, c.wi, c.wo, 0.0, 0.0, 0.0, 0.0);
  bool fine = true;

  f.shaded = lobe_eval(lobe.tag, vec4(lobe.k0, lobe.k1, lobe.k2, lobe.k3), c.wi, c.wo);
  fine = fine && is_number(f.shaded) && (f.shaded >= 0.0 || lobe.may_be_negative != 0u);
  BrdfParams b = BrdfParams(int(lobe.model), int(lobe.variant), lobe.p0, lobe.p1, lobe.p2, lobe.p3, lobe.p4, lobe.p5);
  if (c.wo.z > 0.0 && c.wi.z > 0.0) {
    f.value = brdf_eval(b, c.wi, c.wo);
    f.pdf = brdf_pdf(b, c.wi, c.wo);
    fine = fine && is_number(f.value) && (f.value >= 0.0 || lobe.may_be_negative != 0u);
    fine = fine && is_number(f.pdf) && f.pdf >= 0.0;
  }
  if (c.wo.z > 0.0) {
    vec3 drawn;
    float pdf;
    bool valid = brdf_sample(b, c.wo, c.u, drawn, pdf, f.weight);
    if (valid) fine = fine && is_number(f.weight) && is_number(pdf) && is_number(drawn.x + drawn.y + drawn.z) && drawn.z > 0.0;
  }
  if (fine) return;
  uint place = atomicAdd(count, 1u);
  if (place < FUZZ_KEPT) failures[place] = f;
}
