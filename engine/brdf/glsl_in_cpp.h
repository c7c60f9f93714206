#pragma once
// What the text of shaders/brdf means in C++. A source file that compiles it includes this, opens a namespace of its
// own in which `real`, `vec2`, `vec3` and `vec4` are float or double types, and includes the text there.
#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#define BRDF_CPP
#define REAL(x) real(x)
#define OUT(T) T&
#define SELECT(condition, yes, no) ((condition) ? (yes) : (no))
#define PRECISE

namespace vamp::glsl {
using std::abs;
using std::clamp;
using std::floor;
using std::max;
using std::min;
using std::sqrt;
using uint = uint32_t;
inline int32_t floatBitsToInt(float x) { return std::bit_cast<int32_t>(x); }
inline float intBitsToFloat(int32_t bits) { return std::bit_cast<float>(bits); }
}  // namespace vamp::glsl
