#version 460
#extension GL_EXT_scalar_block_layout : require
// Writes its specialisation constants, one of each type.
layout(local_size_x = 8) in;
layout(constant_id = 0) const uint a = 1;
layout(constant_id = 1) const int b = 2;
layout(constant_id = 2) const float c = 3.0;
layout(constant_id = 7) const bool d = false;
layout(scalar, binding = 0) writeonly buffer To { float values[]; };
void main() {
  if (gl_GlobalInvocationID.x != 0) return;
  values[0] = float(a);
  values[1] = float(b);
  values[2] = c;
  values[3] = d ? 1.0 : 0.0;
}
