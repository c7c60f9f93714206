#include "engine/scene/light.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

namespace vamp {
namespace {

constexpr float kPi = glm::pi<float>();
constexpr std::array<std::string_view, kLightTypeCount> kNames = {"point", "spot", "directional",
                                                                  "rect",  "disk", "sphere"};

bool finite(const vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

LightFrame frame_without_roll(const Light& light) {
  const vec3 axis = light.target - light.center;
  const float length = glm::length(axis);
  LightFrame frame;
  if (length > 0) frame.n = axis / length;
  // sin of 0.1 degrees: nearer to the vertical, "horizontal" no longer says which way u goes.
  const vec3 side = glm::cross(vec3(0, 1, 0), frame.n);
  const float horizontal = glm::length(side);
  frame.u = horizontal > 1.745e-3f ? side / horizontal
                                   : glm::normalize(vec3(1, 0, 0) - frame.n * glm::dot(frame.n, vec3(1, 0, 0)));
  frame.v = glm::cross(frame.n, frame.u);
  return frame;
}

}  // namespace

std::string_view name_of(LightType type) { return kNames[static_cast<size_t>(type)]; }

bool light_type_from_name(std::string_view name, LightType& type) {
  const auto found = std::find(kNames.begin(), kNames.end(), name);
  if (found == kNames.end()) return false;
  type = static_cast<LightType>(found - kNames.begin());
  return true;
}

LightFrame light_frame(const Light& light) {
  LightFrame frame = frame_without_roll(light);
  if (light.roll_degrees == 0) return frame;
  const float roll = glm::radians(light.roll_degrees);
  frame.u = glm::normalize(frame.u * std::cos(roll) + frame.v * std::sin(roll));
  frame.v = glm::cross(frame.n, frame.u);
  return frame;
}

float roll_for_u_axis(const Light& light, const vec3& u_axis) {
  const LightFrame frame = frame_without_roll(light);
  const float along = glm::dot(u_axis, frame.u);
  const float across = glm::dot(u_axis, frame.v);
  return along == 0 && across == 0 ? 0.0f : glm::degrees(std::atan2(across, along));
}

bool is_area_light(LightType type) {
  return type == LightType::rect || type == LightType::disk || type == LightType::sphere;
}

float light_area(const Light& light) {
  switch (light.type) {
    case LightType::rect:
      return light.size.x * light.size.y;
    case LightType::disk:
      return kPi * light.radius * light.radius;
    case LightType::sphere:
      return 4 * kPi * light.radius * light.radius;
    default:
      return 0;
  }
}

vec3 light_radiance(const Light& light) {
  const float area = light_area(light);
  return area > 0 ? light.color * (light.power / (kPi * area)) : vec3(0);
}

vec3 light_intensity(const Light& light) {
  if (is_area_light(light.type)) return vec3(0);
  return light.color * (light.type == LightType::directional ? light.power : light.power / (4 * kPi));
}

vec3 light_emission(const Light& light) {
  if (!light.on) return vec3(0);
  return is_area_light(light.type) ? light_radiance(light) : light_intensity(light);
}

SpotFalloff spot_falloff(const Light& light) {
  if (light.type != LightType::spot) return {};
  // KHR_lights_punctual, "Inner and Outer Cone Angles".
  const float inner = std::cos(glm::radians(light.inner_degrees));
  const float outer = std::cos(glm::radians(light.outer_degrees));
  const float scale = 1.0f / std::max(1e-3f, inner - outer);
  return {scale, -outer * scale};
}

float power_from_candela(float candela) { return 4 * kPi * candela / kLumensPerWatt; }
float candela_from_power(float power) { return power * kLumensPerWatt / (4 * kPi); }
float irradiance_from_lux(float lux) { return lux / kLumensPerWatt; }
float lux_from_irradiance(float irradiance) { return irradiance * kLumensPerWatt; }

std::string light_problem(const Light& light) {
  if (!finite(light.center)) return "center is not finite";
  if (!finite(light.target)) return "target is not finite";
  if (!finite(light.color) || light.color.x < 0 || light.color.y < 0 || light.color.z < 0)
    return "color must be finite and not negative";
  if (!std::isfinite(light.power) || light.power < 0) return "power must be finite and not negative";
  if (!std::isfinite(light.roll_degrees)) return "roll is not finite";
  if (light.type == LightType::rect &&
      !(light.size.x > 0 && light.size.y > 0 && std::isfinite(light.size.x) && std::isfinite(light.size.y)))
    return "size must be above 0";
  if ((light.type == LightType::disk || light.type == LightType::sphere) &&
      !(light.radius > 0 && std::isfinite(light.radius)))
    return "radius must be above 0";
  if (light.type == LightType::spot &&
      !(light.inner_degrees >= 0 && light.inner_degrees < light.outer_degrees && light.outer_degrees <= 90))
    return "cone angles must be 0 <= inner < outer <= 90";
  return {};
}

}  // namespace vamp
