#include "engine/brdf/glsl_in_cpp.h"
#include "engine/brdf/kernel.h"

#define BRDF_DOUBLE

namespace vamp::brdf_f64 {
using namespace glsl;
using real = double;
using vec2 = glm::dvec2;
using vec3 = glm::dvec3;
using vec4 = glm::dvec4;
using glm::dot;

// The oracle's elementary functions are the C++ library's.
real brdf_log2_ratio(real a, real b) { return std::log1p(a / b) * 1.44269504088896341; }
real brdf_exp2(real x) { return std::exp2(x); }
real brdf_expm1(real x) { return std::expm1(x); }
real brdf_angle(real s, real c) { return std::atan2(s, c); }
vec2 brdf_unit_circle(real u) { return {std::cos(6.28318530717958648 * u), std::sin(6.28318530717958648 * u)}; }
real brdf_sum_of_products(real a, real b, real c, real d) { return a * b + c * d; }
real brdf_sum_of_triple_products(vec3 a, vec3 b, vec3 c) { return a.x * b.x * c.x + a.y * b.y * c.y + a.z * b.z * c.z; }
#include "engine/brdf/kernel.inc"
}  // namespace vamp::brdf_f64
