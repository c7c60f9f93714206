#include "engine/project/project.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "engine/core/check.h"
#include "engine/core/log.h"
#include "engine/core/text.h"
#include "engine/project/file_reference.h"
#include "engine/project/fit_checksum.h"
#include "engine/project/known_files.h"
#include "engine/project/limits.h"
#include "engine/project/own_material.h"
#include "engine/project/studio.h"

namespace vamp {
namespace {

constexpr float kFirstAspect = 4.0f / 3.0f;  // of the picture that a model's first view is fitted to

PartState& part_at(Project& project, int part) {
  CHECK(part >= 0 && static_cast<size_t>(part) < project.parts.size());
  return project.parts[static_cast<size_t>(part)];
}

void reset_texture_place(PartState& part) {
  part.texture_scale = 1;
  part.texture_rotation = 0;
  part.texture_offset = vec2(0);
}

// `wanted`, or "wanted 2", "wanted 3", ... so that lists show different names.
std::string unique_name(const Project& project, const std::string& wanted) {
  std::set<std::string_view> taken;
  for (const MaterialInstance& material : project.materials) taken.insert(material.name);
  std::string name = wanted;
  for (int i = 2; taken.contains(name); ++i) name = wanted + " " + std::to_string(i);
  return name;
}

}  // namespace

Project make_project(std::shared_ptr<const Scene> scene, const std::filesystem::path& model) {
  CHECK(scene != nullptr);
  Project project;
  const std::string file = scene->file.empty() ? "the model" : scene->file;
  if (!model.empty()) {
    std::error_code code;
    project.model = std::filesystem::absolute(model, code).lexically_normal();
    project.model_checksum = file_checksum(model).value_or("");
  }
  project.mm_per_unit = scene->mm_per_unit;

  // A material instance for each part.
  for (size_t i = 0; i < scene->parts.size(); ++i) {
    PartState part;
    part.name = scene->parts[i].name;
    part.material = static_cast<int>(i);
    project.materials.push_back(own_material(*scene, static_cast<int>(i)));
    project.parts.push_back(std::move(part));
  }

  // Its own light, or a studio.
  project.lights = scene->lights;
  if (project.lights.size() > kMaxLights) {
    spdlog::warn("{}: {} lights, the first {} are used", file, project.lights.size(), kMaxLights);
    project.lights.resize(kMaxLights);
  }
  project.ambient = scene->ambient.value_or(vec3(0));
  if (project.lights.empty() && !scene->ambient) {
    spdlog::info("{}: no lights; a neutral studio is put around it", file);
    project.lights = studio_lights(scene->bounds);
    project.ambient = vec3(kStudioAmbient);
    project.background = vec3(kStudioBackground);
  }
  project.settings.ao_radius = scene->ao_radius.value_or(0);

  // Its own views, the first of them now; or one that fits it.
  for (const Camera& camera : scene->cameras) {
    if (project.cameras.size() == kMaxNamedCameras) break;
    project.cameras.push_back({camera.name, camera});
  }
  project.camera = project.cameras.empty() ? default_camera(scene->bounds, kFirstAspect) : project.cameras[0].camera;

  project.scene = std::move(scene);
  return project;
}

void drop_unused_materials(Project& project) {
  std::vector<int> place(project.materials.size(), -1);
  for (const PartState& part : project.parts) place[static_cast<size_t>(part.material)] = 0;
  std::vector<MaterialInstance> kept;
  for (size_t i = 0; i < place.size(); ++i) {
    if (place[i] < 0) continue;
    place[i] = static_cast<int>(kept.size());
    kept.push_back(std::move(project.materials[i]));
  }
  project.materials = std::move(kept);
  for (PartState& part : project.parts) part.material = place[static_cast<size_t>(part.material)];
}

void assign_preset(Project& project, int part, const Preset& preset, const std::string& path) {
  CHECK(preset.fit != nullptr);
  PartState& target = part_at(project, part);
  const std::string reference = make_reference(path);
  const std::string checksum = fit_checksum(*preset.fit);
  int index = -1;
  SpmmPtr fit = preset.fit;
  for (size_t i = 0; i < project.materials.size(); ++i) {
    const MaterialInstance& material = project.materials[i];
    if (material.preset != reference || material.checksum != checksum) continue;
    fit = material.fit;  // one table in memory, also for copies that are edited apart
    if (material.edits != preset.edits) continue;
    if (index < 0 || target.material == static_cast<int>(i)) index = static_cast<int>(i);
  }
  if (index < 0) {
    index = static_cast<int>(project.materials.size());
    project.materials.push_back({unique_name(project, preset.name), reference, "", checksum, fit, preset.edits});
  }
  if (target.material != index) reset_texture_place(target);
  target.material = index;
  drop_unused_materials(project);
}

void assign_own_material(Project& project, int part) {
  PartState& target = part_at(project, part);
  MaterialInstance own = own_material(*project.scene, part);
  own.name = unique_name(project, own.name);
  reset_texture_place(target);
  target.material = static_cast<int>(project.materials.size());
  project.materials.push_back(std::move(own));
  drop_unused_materials(project);
}

void share_material(Project& project, int part, int material) {
  CHECK(material >= 0 && static_cast<size_t>(material) < project.materials.size());
  PartState& target = part_at(project, part);
  if (target.material == material) return;
  target.material = material;
  reset_texture_place(target);
  drop_unused_materials(project);
}

int make_unique_material(Project& project, int part) {
  PartState& target = part_at(project, part);
  const auto shared = std::count_if(project.parts.begin(), project.parts.end(),
                                    [&](const PartState& other) { return other.material == target.material; });
  if (shared <= 1) return target.material;
  MaterialInstance copy = project.materials[static_cast<size_t>(target.material)];
  copy.name = unique_name(project, copy.name);
  target.material = static_cast<int>(project.materials.size());
  project.materials.push_back(std::move(copy));
  return target.material;
}

Status assign_environment(Project& project, const std::string& path) {
  const std::string reference = make_reference(path);
  VAMP_TRY(const std::filesystem::path file, path_of_reference(reference, path, ""));
  VAMP_TRY(auto map, load_environment(file));
  VAMP_TRY(project.environment.checksum, file_checksum(file));
  project.environment.path = reference;
  project.environment.map = std::move(map);
  return {};
}

RigidMotion motion_of(const Project& project, size_t part) {
  return {project.parts[part].place, project.scene->parts[part].bounds.center()};
}

int find_part(const Project& project, std::string_view name) {
  for (size_t i = 0; i < project.parts.size(); ++i)
    if (project.parts[i].name == name) return static_cast<int>(i);
  for (size_t i = 0; i < project.parts.size(); ++i)
    if (lower(project.parts[i].name) == lower(name)) return static_cast<int>(i);
  return -1;
}

}  // namespace vamp
