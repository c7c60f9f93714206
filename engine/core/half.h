#pragma once
// IEEE 754 half floats as they lie in files and GPU tables.
#include <glm/gtc/packing.hpp>

#include <cstdint>

namespace vamp {

inline uint16_t half_from_float(float value) { return glm::packHalf1x16(value); }
inline float float_from_half(uint16_t bits) { return glm::unpackHalf1x16(bits); }
inline constexpr float kHalfMax = 65504.0f;

}  // namespace vamp
