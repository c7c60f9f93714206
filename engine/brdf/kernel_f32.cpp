#include "engine/brdf/glsl_in_cpp.h"
#include "engine/brdf/kernel.h"

namespace vamp::brdf_f32 {
using namespace glsl;
using real = float;
using glm::dot;
using glm::vec2;
using glm::vec3;
using glm::vec4;
#include "engine/brdf/kernel.inc"
}  // namespace vamp::brdf_f32
