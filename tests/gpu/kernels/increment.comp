#version 460
#extension GL_EXT_scalar_block_layout : require
// values[i] = 3 * values[i] + 1: the order of dispatches shows.
layout(local_size_x = 64) in;
layout(scalar, binding = 0) buffer Values { uint values[]; };
void main() { values[gl_GlobalInvocationID.x] = 3u * values[gl_GlobalInvocationID.x] + 1u; }
