#version 460
#extension GL_EXT_scalar_block_layout : require
// to[i] = from[i], read after a while: long enough for the host to get in between if nothing held it back.
layout(local_size_x = 64) in;
layout(scalar, binding = 0) readonly buffer From { uint from_values[]; };
layout(scalar, binding = 1) writeonly buffer To { uint to_values[]; };
void main() {
  const uint i = gl_GlobalInvocationID.x;
  uint x = i;
  for (int k = 0; k < 10000; ++k) x = (x ^ (x >> 7)) * 1664525u + 1013904223u;
  // x is no such value for any i in use; the compiler cannot know.
  to_values[i] = from_values[x == 12345u ? 0u : i];
}
