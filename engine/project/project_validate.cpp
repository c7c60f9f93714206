#include <fmt/format.h>

#include <cmath>

#include "engine/material/preset_json.h"
#include "engine/project/limits.h"
#include "engine/project/project.h"

namespace vamp {
namespace {

// Collects the first thing that does not hold.
class Checker {
 public:
  explicit Checker(std::string_view file) : file_(file) {}

  void refuse(const std::string& place, std::string_view expected, const std::string& found) {
    if (status_) status_ = fail(ErrorKind::bad_input, file_, place, expected, found);
  }
  void range(const std::string& place, float value, float low, float high) {
    if (!(value >= low && value <= high))  // also where it is NaN
      refuse(place, fmt::format("a number from {:g} to {:g}", low, high), fmt::format("{}", value));
  }
  void range(const std::string& place, const vec3& value, float low, float high) {
    for (int i = 0; i < 3; ++i) range(place, value[i], low, high);
  }
  void point(const std::string& place, const vec3& value) { range(place, value, -kMaxCoordinate, kMaxCoordinate); }
  void count(const std::string& place, size_t value, size_t most) {
    if (value > most) refuse(place, fmt::format("at most {}", most), std::to_string(value));
  }
  void name(const std::string& place, const std::string& text) {
    if (text.size() > kMaxNameBytes)
      refuse(place, fmt::format("at most {} bytes", kMaxNameBytes), std::to_string(text.size()));
  }
  void add(const Status& status) {
    if (status_ && !status) status_ = status;
  }
  Status status() const { return status_; }

 private:
  std::string_view file_;
  Status status_;
};

void check_light(Checker& check, const Light& light, const std::string& place) {
  check.name(place + ".name", light.name);
  check.point(place + ".center", light.center);
  check.point(place + ".target", light.target);
  check.range(place + ".power", light.power, 0, kMaxPower);
  check.range(place + ".color", light.color, 0, kMaxColor);
  check.range(place + ".roll", light.roll_degrees, -kMaxRoll, kMaxRoll);
  check.range(place + ".inner", light.inner_degrees, 0, 90);
  check.range(place + ".outer", light.outer_degrees, 0, 90);
  check.range(place + ".size", vec3(light.size, 0), 0, kMaxCoordinate);
  check.range(place + ".radius", light.radius, 0, kMaxCoordinate);
  if (light.type == LightType::rect) {
    check.range(place + ".size", light.size.x, kMinLength, kMaxCoordinate);
    check.range(place + ".size", light.size.y, kMinLength, kMaxCoordinate);
  }
  if (light.type == LightType::disk || light.type == LightType::sphere)
    check.range(place + ".radius", light.radius, kMinLength, kMaxCoordinate);
  if (const std::string problem = light_problem(light); !problem.empty())
    check.refuse(place, "a light that can shine", problem);
}

void check_camera(Checker& check, const Camera& camera, const std::string& place) {
  check.name(place + ".name", camera.name);
  check.point(place + ".eye", camera.eye);
  check.point(place + ".target", camera.target);
  check.point(place + ".up", camera.up);
  check.range(place + ".fov", camera.fov_degrees, kMinFovDegrees, kMaxFovDegrees);
}

void check_part(Checker& check, const PartState& part, size_t materials, const std::string& place) {
  if (part.material < 0 || static_cast<size_t>(part.material) >= materials)
    check.refuse(place + ".material", fmt::format("below {}", materials), std::to_string(part.material));
  check.range(place + ".mirror_f0", part.mirror_f0, 0, 1);
  check.range(place + ".texture.scale", part.texture_scale, kMinTextureScale, kMaxTextureScale);
  check.range(place + ".texture.rotation", part.texture_rotation, -kMaxTurn, kMaxTurn);
  check.range(place + ".texture.offset", part.texture_offset.x, -kMaxTextureOffset, kMaxTextureOffset);
  check.range(place + ".texture.offset", part.texture_offset.y, -kMaxTextureOffset, kMaxTextureOffset);
  check.point(place + ".offset", part.place.offset);
  check.range(place + ".turn", part.place.turn, -kMaxTurn, kMaxTurn);
}

}  // namespace

Status validate(const Project& project, std::string_view file) {
  Checker check(file);
  if (project.scene == nullptr) return fail(ErrorKind::bad_input, file, "model", "a model", "none");
  check.range("model.mm_per_unit", project.mm_per_unit, kMinMmPerUnit, kMaxMmPerUnit);

  // Parts and what they show.
  if (project.parts.size() != project.scene->parts.size())
    check.refuse("parts", std::to_string(project.scene->parts.size()), std::to_string(project.parts.size()));
  check.count("parts", project.parts.size(), kMaxParts);
  for (size_t i = 0; i < project.parts.size(); ++i)
    check_part(check, project.parts[i], project.materials.size(), fmt::format("parts[{}]", i));
  for (size_t i = 0; i < project.materials.size(); ++i) {
    const MaterialInstance& material = project.materials[i];
    const std::string place = fmt::format("materials[{}]", i);
    check.name(place + ".name", material.name);
    if (material.fit == nullptr)
      check.refuse(place, "a fit", "none");
    else
      check.add(validate(material.edits, *material.fit, fmt::format("{}: {}", file, place)));
  }

  // Light.
  check.count("lights", project.lights.size(), kMaxLights);
  for (size_t i = 0; i < project.lights.size(); ++i)
    check_light(check, project.lights[i], fmt::format("lights[{}]", i));
  check.range("ambient", project.ambient, 0, kMaxColor);
  check.range("background", project.background, 0, kMaxColor);
  check.range("environment.intensity", project.environment.intensity, 0, kMaxEnvironmentIntensity);
  check.range("environment.rotation", project.environment.rotation, -kMaxTurn, kMaxTurn);

  // Views and settings.
  check_camera(check, project.camera, "camera");
  check.count("cameras", project.cameras.size(), kMaxNamedCameras);
  for (size_t i = 0; i < project.cameras.size(); ++i) {
    const std::string place = fmt::format("cameras[{}]", i);
    check.name(place + ".name", project.cameras[i].name);
    check_camera(check, project.cameras[i].camera, place);
  }
  check.range("render.ao_radius", project.settings.ao_radius, 0, kMaxCoordinate);
  if (project.settings.max_samples < 1 || project.settings.max_samples > kMaxSamples)
    check.refuse("render.max_samples", fmt::format("1 to {}", kMaxSamples),
                 std::to_string(project.settings.max_samples));
  check.range("render.noise_goal", project.settings.noise_goal, 0, 1);
  check.range("display.exposure", project.display.exposure, -kMaxExposure, kMaxExposure);
  return check.status();
}

}  // namespace vamp
