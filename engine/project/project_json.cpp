#include <fmt/format.h>

#include <cmath>

#include "engine/core/files.h"
#include "engine/core/log.h"
#include "engine/material/preset_json.h"
#include "engine/project/fit_checksum.h"
#include "engine/project/light_json.h"
#include "engine/project/limits.h"
#include "engine/project/material_json.h"
#include "engine/project/project_file.h"
#include "engine/project/quantity_json.h"
#include "engine/project/schema.h"

namespace vamp {
namespace {

constexpr Schema kSchema{"vamp-project", 1, 1};

Json part_to_json(const PartState& part, double mm_per_unit) {
  Json json;
  json["name"] = part.name;
  json["material"] = part.material;
  json["visible"] = part.visible;
  json["mirror_f0"] = json_number(part.mirror_f0);
  json["texture_scale"] = json_number(part.texture_scale);
  json["texture_rotation"] = json_quantity(part.texture_rotation, kDegreesPerRadian);
  json["texture_offset"] = json_vector(part.texture_offset);
  json["offset"] = json_vector(part.place.offset, mm_per_unit);
  json["turn"] = json_vector(part.place.turn, kDegreesPerRadian);
  return json;
}

PartState part_from_json(const JsonReader& reader, size_t materials, double mm_per_unit) {
  PartState part;
  part.name = reader.member("name").text();
  part.material = static_cast<int>(reader.member("material").integer(0, static_cast<int64_t>(materials) - 1));
  part.visible = reader.member("visible").boolean();
  part.mirror_f0 = reader.member("mirror_f0").number(0, 1);
  part.texture_scale = reader.member("texture_scale").number(kMinTextureScale, kMaxTextureScale);
  part.texture_rotation = quantity_from(reader.member("texture_rotation"), kDegreesPerRadian, -kMaxTurn, kMaxTurn);
  part.texture_offset = vec2_from(reader.member("texture_offset"), 1, -kMaxTextureOffset, kMaxTextureOffset);
  // In files of schema 1.0 every part stands where the model has it.
  if (reader.has("offset"))
    part.place.offset = vec3_from(reader.member("offset"), mm_per_unit, -kMaxCoordinate, kMaxCoordinate);
  if (reader.has("turn")) part.place.turn = vec3_from(reader.member("turn"), kDegreesPerRadian, -kMaxTurn, kMaxTurn);
  return part;
}

Json render_to_json(const RenderSettings& settings, double mm_per_unit) {
  Json json;
  json["seed"] = settings.seed;
  json["ao_radius"] = json_quantity(settings.ao_radius, mm_per_unit);
  json["pixel_centres"] = settings.pixel_centres;
  json["texel_tap"] = settings.tap == TexelTap::stochastic ? "stochastic" : "four";
  json["max_samples"] = settings.max_samples;
  json["noise_goal"] = settings.noise_goal;
  return json;
}

RenderSettings render_from_json(const JsonReader& reader, double mm_per_unit) {
  RenderSettings settings;
  settings.seed = static_cast<uint32_t>(reader.member("seed").integer(0, UINT32_MAX));
  settings.ao_radius = quantity_from(reader.member("ao_radius"), mm_per_unit, 0, kMaxCoordinate);
  settings.pixel_centres = reader.member("pixel_centres").boolean();
  settings.tap = static_cast<TexelTap>(choice_from(reader.member("texel_tap"), {"stochastic", "four"}));
  settings.max_samples = static_cast<uint32_t>(reader.member("max_samples").integer(1, kMaxSamples));
  // Files from before there was a goal have none.
  if (reader.has("noise_goal")) settings.noise_goal = static_cast<float>(reader.member("noise_goal").number(0, 1));
  return settings;
}

Result<Json> environment_to_json(const EnvironmentState& environment, const fs::path& folder, PathUse use) {
  Json json;
  if (environment.map != nullptr) {
    VAMP_TRY(json["file"], stored_name(environment.path, environment.checksum, folder, use, "the environment map"));
    json["checksum"] = environment.checksum;
  }
  json["intensity"] = json_number(environment.intensity);
  json["rotation"] = json_quantity(environment.rotation, kDegreesPerRadian);
  json["visible"] = environment.visible;
  return json;
}

Status environment_from_json(const JsonReader& reader, const fs::path& folder, std::string_view file, PathUse use,
                             Project& project) {
  EnvironmentState& environment = project.environment;
  environment.intensity = reader.member("intensity").number(0, kMaxEnvironmentIntensity);
  environment.rotation = quantity_from(reader.member("rotation"), kDegreesPerRadian, -kMaxTurn, kMaxTurn);
  environment.visible = reader.member("visible").boolean();
  if (!reader.has("file")) return reader.status();
  const std::string stored = reader.member("file").text();
  const std::string checksum = reader.member("checksum").text(64);
  VAMP_CHECK_STATUS(reader.status());
  const std::string place = reader.path() + ".file";
  VAMP_TRY(const std::string reference, reference_from_stored(stored, checksum, folder, use, file, place));
  VAMP_CHECK_STATUS(assign_environment(project, reference));
  if (!checksum.empty() && environment.checksum != checksum) {
    if (use == PathUse::job)
      return fail(ErrorKind::bad_input, file, place, "the environment map the picture was made with",
                  "\"" + stored + "\" has changed since");
    spdlog::warn("{}: the environment map \"{}\" has changed since it was saved", file, stored);
  }
  return {};
}

// The model, loaded; as a project without any of the document's changes.
Result<Project> model_from_json(const JsonReader& reader, const fs::path& folder, std::string_view file, PathUse use) {
  const std::string stored = reader.member("file").text();
  const std::string checksum = reader.member("checksum").text(64);
  const float mm_per_unit = reader.member("mm_per_unit").number(kMinMmPerUnit, kMaxMmPerUnit);
  VAMP_CHECK_STATUS(reader.status());
  const std::string place = reader.path() + ".file";
  VAMP_TRY(const std::string reference, reference_from_stored(stored, checksum, folder, use, file, place));
  VAMP_TRY(const fs::path path, path_of_reference(reference, file, place));
  VAMP_TRY(auto scene, load_scene(path));
  Project project = make_project(std::move(scene), path);
  project.mm_per_unit = mm_per_unit;
  if (project.model_checksum != checksum) {
    if (use == PathUse::job)
      return fail(ErrorKind::bad_input, file, place, "the model the picture was made with",
                  "\"" + stored + "\" has changed since");
    spdlog::warn("{}: the model \"{}\" has changed since it was saved", file, stored);
  }
  return project;
}

// Puts the document's parts over the model's, by name.
void place_parts(const std::vector<PartState>& parts, std::vector<MaterialInstance> materials, std::string_view file,
                 Project& project) {
  const std::vector<MaterialInstance> own = std::move(project.materials);
  project.materials = std::move(materials);
  std::vector<bool> found(project.parts.size(), false);
  for (const PartState& part : parts) {
    const int index = project.scene->find_part(part.name);
    if (index < 0) {
      spdlog::warn("{}: the model has no part \"{}\" any more", file, part.name);
      continue;
    }
    found[static_cast<size_t>(index)] = true;
    PartState placed = part;
    if (project.materials[static_cast<size_t>(part.material)].fit == nullptr)
      found[static_cast<size_t>(index)] = false;  // shown the own material of a part that is gone
    else
      project.parts[static_cast<size_t>(index)] = std::move(placed);
  }
  for (size_t i = 0; i < found.size(); ++i) {
    if (found[i]) continue;
    spdlog::info("{}: the part \"{}\" is new; it shows the model's own material", file, project.parts[i].name);
    const auto index = static_cast<size_t>(project.parts[i].material);
    project.parts[i].material = static_cast<int>(project.materials.size());
    project.materials.push_back(own[index]);
  }
  drop_unused_materials(project);
}

}  // namespace

Result<Json> project_to_json(const Project& project, const fs::path& folder, PathUse use) {
  VAMP_CHECK_STATUS(validate(project, "the project"));
  const double mm{project.mm_per_unit};
  Json json = kSchema.head();
  json["units"] = {{"length", "mm"}, {"angle", "deg"}, {"color", "linear Rec.709"}};
  Json& model = json["model"] = Json::object();
  VAMP_TRY(model["file"], stored_name(make_reference(project.model), project.model_checksum, folder, use, "the model"));
  model["checksum"] = project.model_checksum;
  model["mm_per_unit"] = json_number(project.mm_per_unit);
  Json& materials = json["materials"] = Json::array();
  for (const MaterialInstance& material : project.materials) {
    VAMP_TRY(Json one, material_to_json(material, folder, use));
    materials.push_back(std::move(one));
  }
  Json& parts = json["parts"] = Json::array();
  for (const PartState& part : project.parts) parts.push_back(part_to_json(part, mm));
  Json& lights = json["lights"] = Json::array();
  for (const Light& light : project.lights) lights.push_back(light_to_json(light, mm));
  json["ambient"] = json_vector(project.ambient);
  json["background"] = json_vector(project.background);
  VAMP_TRY(json["environment"], environment_to_json(project.environment, folder, use));
  json["camera"] = camera_to_json(project.camera, mm);
  Json& cameras = json["cameras"] = Json::array();
  for (const NamedCamera& kept : project.cameras)
    cameras.push_back(Json{{"name", kept.name}, {"camera", camera_to_json(kept.camera, mm)}});
  json["render"] = render_to_json(project.settings, mm);
  json["display"] = {{"exposure", json_number(project.display.exposure)},
                     {"tone_map", project.display.tone_map == ToneMap::pbr_neutral ? "pbr_neutral" : "none"}};
  return json;
}

Result<Project> project_from_json(const JsonReader& reader, const fs::path& folder, std::string_view file,
                                  PathUse use) {
  VAMP_CHECK_STATUS(kSchema.check(reader, file));
  VAMP_TRY(Project project, model_from_json(reader.member("model"), folder, file, use));
  const double mm{project.mm_per_unit};

  // Light, views and settings first: they are cheap to find wrong.
  project.lights.clear();
  const JsonReader lights = reader.member("lights");
  for (size_t i = 0, count = lights.size(kMaxLights); i < count; ++i)
    project.lights.push_back(light_from_json(lights.element(i), mm));
  project.ambient = vec3_from(reader.member("ambient"), 1, 0, kMaxColor);
  project.background = vec3_from(reader.member("background"), 1, 0, kMaxColor);
  project.camera = camera_from_json(reader.member("camera"), mm);
  project.cameras.clear();
  const JsonReader cameras = reader.member("cameras");
  for (size_t i = 0, count = cameras.size(kMaxNamedCameras); i < count; ++i)
    project.cameras.push_back({cameras.element(i).member("name").text(kMaxNameBytes),
                               camera_from_json(cameras.element(i).member("camera"), mm)});
  project.settings = render_from_json(reader.member("render"), mm);
  const JsonReader display = reader.member("display");
  project.display.exposure = display.member("exposure").number(-kMaxExposure, kMaxExposure);
  project.display.tone_map = static_cast<ToneMap>(choice_from(display.member("tone_map"), {"pbr_neutral", "none"}));

  // Parts, then the materials they show.
  const JsonReader part_list = reader.member("parts");
  const size_t material_count = reader.member("materials").size(kMaxParts);
  std::vector<PartState> parts;
  for (size_t i = 0, count = part_list.size(kMaxParts); i < count; ++i)
    parts.push_back(part_from_json(part_list.element(i), material_count, mm));
  VAMP_CHECK_STATUS(reader.status());
  VAMP_TRY(auto materials, materials_from_json(reader.member("materials"), parts, project, folder, file, use));
  place_parts(parts, std::move(materials), file, project);

  VAMP_CHECK_STATUS(environment_from_json(reader.member("environment"), folder, file, use, project));
  VAMP_CHECK_STATUS(reader.status());
  VAMP_CHECK_STATUS(validate(project, file));
  return project;
}

}  // namespace vamp
