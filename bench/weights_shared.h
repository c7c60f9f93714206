// What bench/weights.comp is about; read by GLSL and C++.
#ifdef __cplusplus
#pragma once
#include <cstdint>
namespace vamp::weights {
using uint = std::uint32_t;
#endif

#define BINDING_WEIGHT_ENTRIES 0
#define BINDING_WEIGHT_BASES 1
#define BINDING_WEIGHT_SUMS 2
#define SPEC_WEIGHTS 0
#define WEIGHTS_FLOAT 0  // RGBA32UI: function, three floats
#define WEIGHTS_HALF 1   // RG32UI: function in 16 bits, three halves; what materials have (shaders/shared/tables.h)
#define WEIGHTS_BYTES 2  // R32UI: function in 8 bits, three square roots in 8 bits
#define WEIGHTS_GROUP_SIZE 64

struct WeightsPush {
  uint pixels, functions;  // functions of each pixel
  float byte_scale;        // weight of a byte: scale * byte^2
};

#ifdef __cplusplus
static_assert(sizeof(WeightsPush) == 12);
}  // namespace vamp::weights
#endif
