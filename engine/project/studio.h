#pragma once
// The light that a model without any is shown in.
#include <vector>

#include "engine/scene/bounds.h"
#include "engine/scene/light.h"

namespace vamp {

inline constexpr float kStudioAmbient = 0.15f;
inline constexpr float kStudioBackground = 0.18f;  // middle grey, so that colour can be judged

// Two soft rectangles fitted to the model: a key from the left, above and in front, and a fill of a quarter of its
// irradiance from the right. A white matte surface that faces the key shows a radiance of about 0.8 from it.
std::vector<Light> studio_lights(const Bounds& bounds);

}  // namespace vamp
