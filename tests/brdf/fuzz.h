// Cases made of any bits, the same on the device and in C++: scalar layout, 4-byte members.
#ifdef __cplusplus
#pragma once
#include <bit>
#include <cmath>

#include "engine/core/vec.h"
#include "shaders/shared/random.h"
namespace vamp::fuzz {
using uint = std::uint32_t;
using random::random_float;
using random::random_hash;
using std::sqrt;
inline float uintBitsToFloat(uint bits) { return std::bit_cast<float>(bits); }
#define FUZZ_FN inline
#else
#include "shaders/shared/random.h"
#define FUZZ_FN
#endif

#define FUZZ_LOBES 0
#define FUZZ_FAILURES 1
#define FUZZ_KEPT 16u

struct FuzzLobe {
  uint model, variant, tag, may_be_negative;
  float p0, p1, p2, p3, p4, p5;
  float k0, k1, k2, k3;
};

struct FuzzPush {
  uint first, seed, lobes;
};

struct FuzzFailure {
  uint index, lobe;
  vec3 wi, wo;
  float shaded, value, pdf, weight;
};

struct FuzzCase {
  vec3 wi, wo;
  vec2 u;
};

// Any float of at most about 1: sign and mantissa as they come, the exponent below 1's, denormals and zeros among them.
FUZZ_FN float fuzz_float(uint bits) {
  uint exponent = (bits >> 23) & 255u;
  return uintBitsToFloat((bits & 0x807fffffu) | ((exponent % 127u) << 23));
}

// A direction, by `kind`: of unit length but for a thousandth, grazing with any small cosine, or any bits at all.
FUZZ_FN vec3 fuzz_direction(uint kind, uint a, uint b, uint c) {
  vec3 raw = vec3(fuzz_float(a), fuzz_float(b), fuzz_float(c));
  if (kind == 0u) return raw;
  float z = kind == 1u ? raw.z : 2.0f * random_float(c) - 1.0f;
  float x = 2.0f * random_float(a) - 1.0f;
  float y = 2.0f * random_float(b) - 1.0f;
  float size = (0.999f + 0.002f * random_float(a ^ b)) / sqrt(x * x + y * y + z * z + 1e-20f);
  return vec3(x * size, y * size, kind == 1u ? z : z * size);
}

FUZZ_FN FuzzCase fuzz_case(uint index, uint seed) {
  uint h0 = random_hash(index ^ seed);
  uint h1 = random_hash(h0 + 0x9e3779b9u);
  uint h2 = random_hash(h1 + 0x9e3779b9u);
  uint h3 = random_hash(h2 + index);
  uint h4 = random_hash(h3 + 0x9e3779b9u);
  uint h5 = random_hash(h4 + 0x9e3779b9u);
  uint h6 = random_hash(h5 + 0x9e3779b9u);
  FuzzCase c;
  c.wi = fuzz_direction(h6 & 3u, h0, h1, h2);
  c.wo = fuzz_direction((h6 >> 2) & 3u, h3, h4, h5);
  // Every fourth pair nearly mirrors, meets or opposes itself.
  uint relation = (h6 >> 4) & 15u;
  float tiny = random_float(h0) * random_float(h1) * 1e-3f;
  if (relation == 0u) c.wi = vec3(-c.wo.x, -c.wo.y, c.wo.z + tiny);
  if (relation == 1u) c.wi = vec3(c.wo.x + tiny, c.wo.y, c.wo.z);
  if (relation == 2u) c.wi = vec3(-c.wo.x, tiny - c.wo.y, tiny);
  if (relation == 3u) c.wi = vec3(-c.wo.x, -c.wo.y, c.wo.z);
  c.u = vec2(random_float(h2), random_float(h6));
  if ((h6 >> 8 & 63u) == 0u) c.u.y = 0.0f;
  if ((h6 >> 8 & 63u) == 1u) c.u.y = 0.999999940395355224609375f;
  return c;
}

#ifdef __cplusplus
static_assert(sizeof(FuzzLobe) == 56 && sizeof(FuzzFailure) == 48);
}  // namespace vamp::fuzz
#endif
