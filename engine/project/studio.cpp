#include "engine/project/studio.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include "engine/project/limits.h"

namespace vamp {
namespace {

constexpr float kDistance = 3.0f;  // of a light from the model's centre, in radii of the model
constexpr float kSide = 1.8f;      // of a light, in radii: half shadows about a third of the model wide

// A white matte surface at distance d on the axis receives about E = P / (pi d^2) and shows E / pi.
float power_for(float shown, float distance) {
  return shown * glm::pi<float>() * glm::pi<float>() * distance * distance;
}

}  // namespace

std::vector<Light> studio_lights(const Bounds& bounds) {
  const vec3 center = bounds.center();
  float radius = bounds.empty() ? 1.0f : bounds.radius();
  if (!std::isfinite(radius) || radius <= 0) radius = 1.0f;
  radius = std::clamp(radius, 1e-4f, kMaxCoordinate / 8);
  const auto light = [&](const char* name, vec3 direction, float shown) {
    Light rect;
    rect.name = name;
    rect.type = LightType::rect;
    rect.target = center;
    rect.center = center + glm::normalize(direction) * (kDistance * radius);
    rect.size = vec2(kSide * radius);
    rect.power = power_for(shown, kDistance * radius);
    return rect;
  };
  return {light("key", {-0.6f, 0.9f, 0.7f}, 0.8f), light("fill", {0.9f, 0.5f, 0.4f}, 0.2f)};
}

}  // namespace vamp
