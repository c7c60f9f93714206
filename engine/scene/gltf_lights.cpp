// Cameras and lights of a glTF: both look along their node's -Z.
#include <tiny_gltf.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "engine/scene/gltf_material.h"

namespace vamp {
namespace {

// A node's axes in the world: unit vectors, and the lengths they had.
struct Axes {
  dvec3 x, y, z, origin;
  double scale_x, scale_y;
};

dvec3 unit_or(const dvec3& v, const dvec3& otherwise) {
  const double length = glm::length(v);
  return length > 0 ? v / length : otherwise;
}

Axes axes_of(const glm::dmat4& m) {
  const dvec3 x(m[0]);
  const dvec3 y(m[1]);
  return {unit_or(x, dvec3(1, 0, 0)),
          unit_or(y, dvec3(0, 1, 0)),
          unit_or(dvec3(m[2]), dvec3(0, 0, 1)),
          dvec3(m[3]),
          glm::length(x),
          glm::length(y)};
}

void place(Light& light, const Axes& axes) {
  light.center = vec3(axes.origin);
  light.target = vec3(axes.origin - axes.z);
}

}  // namespace

std::optional<Camera> read_camera(const tinygltf::Model& model, int index, const glm::dmat4& world_from_node,
                                  const Bounds& bounds) {
  const tinygltf::Camera& source = model.cameras[static_cast<size_t>(index)];
  if (source.type != "perspective") return std::nullopt;
  const Axes axes = axes_of(world_from_node);
  Camera camera;
  camera.name = source.name;
  camera.eye = vec3(axes.origin);
  camera.up = vec3(axes.y);
  // Orbiting turns about the target, so it lies at the depth of the model's middle.
  const double depth = bounds.empty() ? 1.0 : glm::dot(dvec3(bounds.center()) - axes.origin, -axes.z);
  const double least = bounds.empty() ? 1.0 : std::max(0.05 * static_cast<double>(bounds.radius()), 1e-6);
  camera.target = vec3(axes.origin - axes.z * std::max(depth, least));
  camera.fov_degrees = std::clamp(static_cast<float>(glm::degrees(source.perspective.yfov)), 1.0f, 170.0f);
  return camera;
}

Light read_punctual_light(const tinygltf::Model& model, int index, const glm::dmat4& world_from_node) {
  const tinygltf::Light& source = model.lights[static_cast<size_t>(index)];
  Light light;
  light.name = source.name;
  light_type_from_name(source.type, light.type);
  place(light, axes_of(world_from_node));
  for (int k = 0; k < 3 && source.color.size() == 3; ++k)
    light.color[k] = static_cast<float>(source.color[static_cast<size_t>(k)]);
  const auto intensity = static_cast<float>(source.intensity);
  light.power = light.type == LightType::directional ? irradiance_from_lux(intensity) : power_from_candela(intensity);
  if (light.type == LightType::spot) {
    light.outer_degrees = std::clamp(static_cast<float>(glm::degrees(source.spot.outerConeAngle)), 0.1f, 90.0f);
    light.inner_degrees =
        std::clamp(static_cast<float>(glm::degrees(source.spot.innerConeAngle)), 0.0f, light.outer_degrees * 0.9999f);
  }
  return light;
}

Result<Light> read_vamp_light(const JsonReader& json, const glm::dmat4& world_from_node, const std::string& node_name) {
  Light light;
  const std::string type = json.member("type").text(32);
  VAMP_CHECK_STATUS(json.status());
  if (!light_type_from_name(type, light.type) || light.type == LightType::spot || light.type == LightType::directional)
    json.member("type").refuse("rect, disk, sphere or point", type);
  const Axes axes = axes_of(world_from_node);
  place(light, axes);
  light.name = json.has("name") ? json.member("name").text(200) : node_name;
  if (json.has("power")) light.power = json.member("power").number(0, 1e12f);
  const auto length = [&](std::string_view key, float otherwise, double scale) {
    const float value = json.has(key) ? json.member(key).number(1e-6f, 1e6f) : otherwise;
    return static_cast<float>(static_cast<double>(value) * scale);
  };
  light.size = vec2(length("width", 1, axes.scale_x), length("height", 1, axes.scale_y));
  light.radius = length("radius", 0.1f, axes.scale_x);
  if (json.has("color")) {
    const JsonReader color = json.member("color");
    if (color.size(16) != 3) color.refuse("3 numbers", std::to_string(color.size(16)));
    for (size_t k = 0; k < 3; ++k) light.color[static_cast<int>(k)] = color.element(k).number(0, 1e6f);
  }
  VAMP_CHECK_STATUS(json.status());
  light.roll_degrees = roll_for_u_axis(light, vec3(axes.x));
  if (const std::string problem = light_problem(light); !problem.empty()) json.refuse("a light that works", problem);
  VAMP_CHECK_STATUS(json.status());
  return light;
}

}  // namespace vamp
