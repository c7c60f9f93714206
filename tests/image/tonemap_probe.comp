#version 460
// Holds shaders/shared/tonemap.h as GLSL.
#extension GL_GOOGLE_include_directive : require
#include "shaders/shared/tonemap.h"

layout(local_size_x = 1) in;
layout(std430, binding = 0) buffer Colours { vec4 colours[]; };

void main() {
  vec4 colour = colours[gl_GlobalInvocationID.x];
  vec3 light = tone_display(colour.xyz, colour.w, TONE_CURVE_NEUTRAL);
  colours[gl_GlobalInvocationID.x] = vec4(srgb_encoded(light), srgb_decode(colour.w));
}
