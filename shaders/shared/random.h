// Counter-based low-discrepancy numbers: shuffled, Owen-scrambled Sobol points in two dimensions (Burley, "Practical
// hash-based Owen scrambling", JCGT 2020; hash of Laine & Karras 2011 in N. Vegdahl's improved form), padded by a seed of
// their own for every pair of dimensions. Any sample of any pixel can be drawn again. Read by GLSL and C++.
#ifdef __cplusplus
#pragma once
#include "engine/core/vec.h"
namespace vamp::random {
using uint = std::uint32_t;
inline uint bitfieldReverse(uint x) {
  x = ((x >> 1) & 0x55555555u) | ((x & 0x55555555u) << 1);
  x = ((x >> 2) & 0x33333333u) | ((x & 0x33333333u) << 2);
  x = ((x >> 4) & 0x0f0f0f0fu) | ((x & 0x0f0f0f0fu) << 4);
  x = ((x >> 8) & 0x00ff00ffu) | ((x & 0x00ff00ffu) << 8);
  return (x >> 16) | (x << 16);
}
#define RANDOM_FN inline
#else
#define RANDOM_FN
#endif

// Pairs of dimensions. A mirror's second vertex adds PAIR_MIRROR.
#define PAIR_PIXEL 0u
#define PAIR_TEXEL 1u
#define PAIR_AMBIENT 2u
#define PAIR_AMBIENT_CHOICE 3u
#define PAIR_ENVIRONMENT_CELL 4u
#define PAIR_ENVIRONMENT_TEXEL 5u
#define PAIR_OCCLUSION 6u
#define PAIR_LIGHT 8u
#define PAIR_MIRROR 32u

// PCG's output permutation over a linear congruence (O'Neill 2014).
RANDOM_FN uint random_hash(uint x) {
  uint state = x * 747796405u + 2891336453u;
  uint word = ((state >> ((state >> 28) + 4u)) ^ state) * 277803737u;
  return (word >> 22) ^ word;
}

// Seed of a pixel of the whole picture.
RANDOM_FN uint random_pixel(uint x, uint y, uint seed) { return random_hash(x + random_hash(y + random_hash(seed))); }

// Nested uniform scramble of a bit-reversed number.
RANDOM_FN uint random_scramble_reversed(uint x, uint seed) {
  x ^= x * 0x3d20adeau;
  x += seed;
  x *= (seed >> 16) | 1u;
  x ^= x * 0x05526c56u;
  x ^= x * 0x53a22864u;
  return x;
}

// 24 bits: always below 1.
RANDOM_FN float random_float(uint x) { return float(x >> 8) * 5.9604644775390625e-8f; }

// Point `index` of the pixel's sequence for a pair of dimensions, in [0, 1)^2.
RANDOM_FN vec2 random_pair(uint pixel, uint index, uint pair) {
  uint seed = random_hash(pixel ^ (pair * 0x9e3779b9u));
  uint shuffled = bitfieldReverse(random_scramble_reversed(bitfieldReverse(index), seed));
  // The second Sobol dimension's generator matrix is Pascal's triangle mod 2: a superset sum over the bits (Lucas).
  uint y = shuffled;
  y ^= (y >> 1) & 0x55555555u;
  y ^= (y >> 2) & 0x33333333u;
  y ^= (y >> 4) & 0x0f0f0f0fu;
  y ^= (y >> 8) & 0x00ff00ffu;
  y ^= y >> 16;
  uint seed_x = random_hash(seed);
  uint seed_y = random_hash(seed_x);
  return vec2(random_float(bitfieldReverse(random_scramble_reversed(shuffled, seed_x))),
              random_float(bitfieldReverse(random_scramble_reversed(y, seed_y))));
}

#ifdef __cplusplus
}  // namespace vamp::random
#endif
