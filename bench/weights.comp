#version 460
// Sums of weighted functions as a pixel's material is summed, with weights in one of several forms.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "bench/weights_shared.h"

layout(local_size_x = WEIGHTS_GROUP_SIZE) in;
layout(constant_id = SPEC_WEIGHTS) const uint FORM = WEIGHTS_HALF;
#define LOBE_MODELS 127u
#include "shaders/brdf/lobe.glsl"

layout(binding = BINDING_WEIGHT_ENTRIES) uniform usamplerBuffer entries;
layout(binding = BINDING_WEIGHT_BASES) uniform samplerBuffer bases;  // k; scale, tag
layout(scalar, binding = BINDING_WEIGHT_SUMS) writeonly buffer Sums { vec3 sums[]; };
layout(push_constant, scalar) uniform Push { WeightsPush push; };

// w in thousandths of a turn and a cosine: any direction, the same on the CPU.
vec3 direction(uint i) {
  float x = float(i % 61u) * (1.2 / 61.0) - 0.6;
  float y = float(i % 47u) * (1.2 / 47.0) - 0.6;
  return vec3(x, y, sqrt(1.0 - x * x - y * y));
}

void main() {
  uint pixel = gl_GlobalInvocationID.x;
  if (pixel >= push.pixels) return;
  vec3 wo = direction(pixel);
  vec3 wi = direction(pixel * 3u + 7u);
  vec3 sum = vec3(0.0);
  for (uint e = 0u; e < push.functions; ++e) {
    uvec4 entry = texelFetch(entries, int(pixel * push.functions + e));
    uint basis = entry.x & 0xffffu;
    vec3 weight = vec3(unpackHalf2x16(entry.x).y, unpackHalf2x16(entry.y));
    if (FORM == WEIGHTS_FLOAT) weight = uintBitsToFloat(entry.yzw);
    if (FORM == WEIGHTS_BYTES) {
      basis = entry.x & 0xffu;
      vec3 root = vec3(entry.x >> 8 & 0xffu, entry.x >> 16 & 0xffu, entry.x >> 24);
      weight = root * root * push.byte_scale;
    }
    vec4 k = texelFetch(bases, int(2u * basis));
    vec4 scale = texelFetch(bases, int(2u * basis + 1u));
    uint tag = floatBitsToUint(scale.y);
    sum += weight * (scale.x * lobe_eval_view(tag, k, wi, lobe_view(tag, k, wo)));
  }
  sums[pixel] = sum;
}
