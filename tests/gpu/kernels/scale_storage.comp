#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require
// to[i] = factor * from[i] + shift, through storage buffers.
#include "tests/gpu/kernels/probe.h"
layout(local_size_x = 64) in;
layout(constant_id = 0) const float factor = 1.0;
layout(scalar, binding = 0) readonly buffer From { float from_values[]; };
layout(scalar, binding = 1) buffer To { float to_values[]; };
layout(scalar, push_constant) uniform Push { ScalePush push; };
void main() {
  const uint i = gl_GlobalInvocationID.x;
  if (i < push.count) to_values[i] = factor * from_values[i] + push.shift;
}
