#include "engine/project/light_json.h"

#include "engine/project/limits.h"
#include "engine/project/quantity_json.h"

namespace vamp {
namespace {

vec3 place_from(const JsonReader& reader, double mm_per_unit) {
  return vec3_from(reader, mm_per_unit, -kMaxCoordinate, kMaxCoordinate);
}

// Sizes that a light's type has no use for may be anything; light_problem looks at the others.
float length_from(const JsonReader& reader, double mm_per_unit) {
  return quantity_from(reader, mm_per_unit, 0, kMaxCoordinate);
}

}  // namespace

Json light_to_json(const Light& light, double mm_per_unit) {
  Json json;
  json["name"] = light.name;
  json["type"] = name_of(light.type);
  json["on"] = light.on;
  json["center"] = json_vector(light.center, mm_per_unit);
  json["target"] = json_vector(light.target, mm_per_unit);
  json["roll"] = json_number(light.roll_degrees);
  json["size"] = json_vector(light.size, mm_per_unit);
  json["radius"] = json_quantity(light.radius, mm_per_unit);
  json["power"] = json_number(light.power);
  json["color"] = json_vector(light.color);
  json["inner"] = json_number(light.inner_degrees);
  json["outer"] = json_number(light.outer_degrees);
  return json;
}

Light light_from_json(const JsonReader& reader, double mm_per_unit) {
  Light light;
  light.name = reader.member("name").text(kMaxNameBytes);
  const std::string type = reader.member("type").text(64);
  if (!light_type_from_name(type, light.type))
    reader.member("type").refuse("rect, disk, sphere, point, spot or directional", "\"" + type + "\"");
  light.on = reader.member("on").boolean();
  light.center = place_from(reader.member("center"), mm_per_unit);
  light.target = place_from(reader.member("target"), mm_per_unit);
  light.roll_degrees = reader.member("roll").number(-kMaxRoll, kMaxRoll);
  light.size = vec2_from(reader.member("size"), mm_per_unit, 0, kMaxCoordinate);
  light.radius = length_from(reader.member("radius"), mm_per_unit);
  light.power = reader.member("power").number(0, kMaxPower);
  light.color = vec3_from(reader.member("color"), 1, 0, kMaxColor);
  light.inner_degrees = reader.member("inner").number(0, 90);
  light.outer_degrees = reader.member("outer").number(0, 90);
  if (const std::string problem = light_problem(light); !problem.empty())
    reader.refuse("a light that can shine", problem);
  return light;
}

Json camera_to_json(const Camera& camera, double mm_per_unit) {
  Json json;
  json["name"] = camera.name;
  json["eye"] = json_vector(camera.eye, mm_per_unit);
  json["target"] = json_vector(camera.target, mm_per_unit);
  json["up"] = json_vector(camera.up);
  json["fov"] = json_number(camera.fov_degrees);
  return json;
}

Camera camera_from_json(const JsonReader& reader, double mm_per_unit) {
  Camera camera;
  camera.name = reader.member("name").text(kMaxNameBytes);
  camera.eye = place_from(reader.member("eye"), mm_per_unit);
  camera.target = place_from(reader.member("target"), mm_per_unit);
  camera.up = vec3_from(reader.member("up"), 1, -kMaxCoordinate, kMaxCoordinate);
  camera.fov_degrees = reader.member("fov").number(kMinFovDegrees, kMaxFovDegrees);
  return camera;
}

}  // namespace vamp
