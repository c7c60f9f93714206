#pragma once
// Lights: radiant, linear Rec.709 colour times power. Lengths in scene units, angles in degrees.
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/vec.h"

namespace vamp {

enum class LightType : int { point, spot, directional, rect, disk, sphere };
inline constexpr int kLightTypeCount = 6;

// "point", "spot", "directional", "rect", "disk", "sphere", as on the command line and in files.
std::string_view name_of(LightType type);
// False when `name` is none of them.
bool light_type_from_name(std::string_view name, LightType& type);

struct Light {
  std::string name;
  LightType type = LightType::rect;
  bool on = true;
  vec3 center{0, 1, 0};      // directional: shines from center to target, otherwise without a place
  vec3 target{0, 0, 0};      // where rect, disk, spot and directional look; point and sphere ignore it
  float roll_degrees = 0;    // rect: turns the u axis about the direction of view, see light_frame()
  vec2 size{1, 1};           // rect: width along u, height along v
  float radius = 0.1f;       // disk, sphere
  float power = 100;         // W, >= 0; directional: irradiance at normal incidence in W per square scene unit
  vec3 color{1, 1, 1};       // linear RGB, >= 0
  float inner_degrees = 0;   // spot: half angle of full intensity
  float outer_degrees = 45;  // spot: half angle where the light ends, > inner, <= 90

  bool operator==(const Light&) const = default;
};

// The light's axes: n = normalize(target - center), the side that emits; u and v span a rect, v = cross(n, u).
// u is horizontal: normalize(cross(+Y, n)), or +X where n is within 0.1 degrees of vertical; then turned about n
// by roll_degrees (right-hand rule). Coinciding center and target shine along -Y.
struct LightFrame {
  vec3 u{1, 0, 0};
  vec3 v{0, 0, 1};
  vec3 n{0, -1, 0};
};
LightFrame light_frame(const Light& light);

// The roll that makes u as close as possible to `u_axis`.
float roll_for_u_axis(const Light& light, const vec3& u_axis);

// Emitting area in square scene units: width * height, pi r^2, 4 pi r^2 (sphere); 0 for point, spot and directional.
float light_area(const Light& light);

bool is_area_light(LightType type);

// Rect and disk (one-sided) and sphere are Lambertian emitters: color * power / (pi * area), W / (sr unit^2).
// Zero for other types and for an area of zero.
vec3 light_radiance(const Light& light);

// Point and spot (inside its inner cone): color * power / (4 pi), W / sr. Directional: color * power, W / unit^2.
// Zero for area lights.
vec3 light_intensity(const Light& light);

// What a light's colour and power come to in the renderer: radiance of area lights, intensity of the others. 0 when
// off.
vec3 light_emission(const Light& light);

// The spot's smooth edge of KHR_lights_punctual: clamp(cos_angle * scale + offset, 0, 1)^2, cos_angle = dot(n, to
// point).
struct SpotFalloff {
  float scale = 0;
  float offset = 1;
};
SpotFalloff spot_falloff(const Light& light);

// KHR_lights_punctual is luminous (cd, lux); watts follow by 683 lm/W.
inline constexpr float kLumensPerWatt = 683.0f;
float power_from_candela(float candela);  // point, spot: 4 pi cd / 683
float candela_from_power(float power);
float irradiance_from_lux(float lux);  // directional: lux / 683
float lux_from_irradiance(float irradiance);

// What is wrong with a light's numbers (not finite, negative, empty), or nothing.
std::string light_problem(const Light& light);

}  // namespace vamp
