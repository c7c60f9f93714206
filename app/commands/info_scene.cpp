// Models and projects: parts, lights, cameras. Lengths in scene units unless a name says mm.
#include "app/commands/info.h"
#include "engine/material/tables.h"
#include "engine/project/project_file.h"
#include "engine/project/quantity_json.h"

namespace vamp {
namespace {

template <class Vector>
Json row(const Vector& vector) {
  Json json = Json::array();
  for (int i = 0; i < Vector::length(); ++i) json.push_back(json_number(vector[i]));
  return json;
}

Json light_info(const Light& light) {
  Json json;
  json["name"] = light.name;
  json["type"] = name_of(light.type);
  if (!light.on) json["on"] = false;
  json["power"] = json_number(light.power);
  json["color"] = row(light.color);
  json["center"] = row(light.center);
  if (light.type != LightType::point && light.type != LightType::sphere) json["target"] = row(light.target);
  if (light.type == LightType::rect) json["size"] = row(light.size);
  if (light.type == LightType::disk || light.type == LightType::sphere) json["radius"] = json_number(light.radius);
  if (light.type == LightType::spot) {
    json["inner_degrees"] = json_number(light.inner_degrees);
    json["outer_degrees"] = json_number(light.outer_degrees);
  }
  return json;
}

Json camera_info(const Camera& camera) {
  Json json;
  json["name"] = camera.name;
  json["eye"] = row(camera.eye);
  json["target"] = row(camera.target);
  json["fov_degrees"] = json_number(camera.fov_degrees);
  return json;
}

Json lights_info(const std::vector<Light>& lights) {
  Json json = Json::array();
  for (const Light& light : lights) json.push_back(light_info(light));
  return json;
}

// What glTF says of a part's look.
Json surface_info(const SurfaceMaterial& material) {
  Json json;
  json["base_color"] = row(material.base_color);
  json["metallic"] = json_number(material.metallic);
  json["roughness"] = json_number(material.roughness);
  json["textures"] = (material.base_color_texture.texture >= 0) + (material.metallic_roughness_texture.texture >= 0) +
                     (material.normal_texture.texture >= 0);
  return json;
}

Json part_info(const Scene& scene, const Part& part) {
  const double mm = static_cast<double>(scene.mm_per_unit);
  Json json;
  json["name"] = part.name;
  json["triangles"] = part.triangle_count;
  json["mm_per_uv"] = json_number(part.mm_per_uv);
  json["area_mm2"] = json_number(static_cast<float>(part.area * mm * mm));
  json["uv"] = part.uv_generated ? "generated" : "own";
  return json;
}

// What models and projects have in common.
Json scene_info(const Scene& scene, const fs::path& path, const char* kind) {
  Json json;
  json["file"] = path.string();
  json["kind"] = kind;
  json["triangles"] = scene.triangles.size();
  json["vertices"] = scene.positions.size();
  json["mm_per_unit"] = json_number(scene.mm_per_unit);
  json["size_mm"] = row((scene.bounds.hi - scene.bounds.lo) * scene.mm_per_unit);
  return json;
}

}  // namespace

Result<Json> model_info(const fs::path& path) {
  VAMP_TRY(const auto scene, load_scene(path));
  Json json = scene_info(*scene, path, "model");
  json["generator"] = scene->generator;
  json["textures"] = scene->textures.size();
  json["parts"] = Json::array();
  for (const Part& part : scene->parts) {
    Json entry = part_info(*scene, part);
    entry["material"] = surface_info(part.material);
    json["parts"].push_back(std::move(entry));
  }
  json["lights"] = lights_info(scene->lights);
  json["ambient"] = scene->ambient ? row(*scene->ambient) : Json();
  json["cameras"] = Json::array();
  for (const Camera& camera : scene->cameras) json["cameras"].push_back(camera_info(camera));
  json["notes"] = scene->notes;
  return json;
}

Result<Json> project_info(const fs::path& path) {
  VAMP_TRY(const Project project, load_project(path));
  Json json = scene_info(*project.scene, path, "project");
  json["model"] = project.model.filename().string();
  uint64_t bytes = 0;
  for (const MaterialInstance& material : project.materials) bytes += bytes_on_gpu(*material.fit);
  json["material_bytes_on_gpu"] = bytes;
  json["parts"] = Json::array();
  for (size_t i = 0; i < project.parts.size(); ++i) {
    const PartState& state = project.parts[i];
    const MaterialInstance& material = project.materials[static_cast<size_t>(state.material)];
    Json entry = part_info(*project.scene, project.scene->parts[i]);
    entry["material"] = material.name;
    entry["preset"] = material.preset.empty() ? Json() : Json(material.preset);
    entry["edited_rows"] = material.edits.bases.size();
    entry["visible"] = state.visible;
    entry["mirror_f0"] = json_number(state.mirror_f0);
    entry["offset_mm"] = json_vector(state.place.offset, static_cast<double>(project.mm_per_unit));
    entry["turn_degrees"] = json_vector(state.place.turn, kDegreesPerRadian);
    json["parts"].push_back(std::move(entry));
  }
  json["lights"] = lights_info(project.lights);
  json["ambient"] = row(project.ambient);
  json["background"] = row(project.background);
  json["environment"] = project.environment.path.empty() ? Json() : Json(project.environment.path);
  json["camera"] = camera_info(project.camera);
  json["cameras"] = Json::array();
  for (const NamedCamera& camera : project.cameras) {
    json["cameras"].push_back(camera_info(camera.camera));
    json["cameras"].back()["name"] = camera.name;
  }
  json["seed"] = project.settings.seed;
  json["exposure"] = json_number(project.display.exposure);
  return json;
}

}  // namespace vamp
