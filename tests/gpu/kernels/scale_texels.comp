#version 460
#extension GL_EXT_scalar_block_layout : require
#extension GL_GOOGLE_include_directive : require
// to[i] = factor * from[i] + shift, through texel buffers; four floats a texel.
#include "tests/gpu/kernels/probe.h"
layout(local_size_x = 64) in;
layout(constant_id = 0) const float factor = 1.0;
layout(binding = 0) uniform samplerBuffer from_values;
layout(binding = 1, rgba32f) uniform writeonly imageBuffer to_values;
layout(scalar, push_constant) uniform Push { ScalePush push; };
void main() {
  const int i = int(gl_GlobalInvocationID.x);
  if (i < int(push.count)) imageStore(to_values, i, factor * texelFetch(from_values, i) + push.shift);
}
