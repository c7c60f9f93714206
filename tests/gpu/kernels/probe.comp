#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require
// Uses a struct shared with C++, so that its layout is in the SPIR-V.
#include "tests/gpu/kernels/probe.h"
layout(local_size_x = 8) in;
layout(scalar, binding = 0) readonly buffer Probes { Probe probes[]; };
layout(scalar, binding = 1) writeonly buffer To { float values[]; };
void main() {
  const uint i = gl_GlobalInvocationID.x;
  const Probe p = probes[i];
  values[i] = p.first + p.normal.y + float(p.index) + p.uv.y + float(p.slots[2]) + p.last;
}
