#include "editor/model/edits_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/core/text.h"
#include "engine/project/limits.h"

namespace vamp {
namespace {

bool finite(const vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

template <class Vector>
bool within(int index, const Vector& list) {
  return index >= 0 && static_cast<size_t>(index) < list.size();
}

Edit make_edit(std::string name, std::string merge_key, std::function<void(Project&)> change) {
  return {std::move(name), std::move(merge_key), std::move(change)};
}

// An edit of one part, named after it.
template <class Change>
Edit edit_part(const Project& project, int part, std::string_view what, Change change) {
  const std::string name = within(part, project.parts) ? project.parts[static_cast<size_t>(part)].name : "no part";
  return make_edit(fmt::format("{} of {}", what, name), fmt::format("{} part {}", what, part),
                   [part, change = std::move(change)](Project& target) {
                     if (within(part, target.parts)) change(target, target.parts[static_cast<size_t>(part)]);
                   });
}

// Leaves what is not finite, clamps the rest.
void set_clamped(float& value, float wanted, float low, float high) {
  if (std::isfinite(wanted)) value = std::clamp(wanted, low, high);
}

template <class List, class Name>
std::string unique_name(const List& list, const std::string& wanted, Name name_of_item) {
  const auto taken = [&](const std::string& name) {
    return std::any_of(list.begin(), list.end(), [&](const auto& item) { return name_of_item(item) == name; });
  };
  std::string name = wanted.substr(0, kMaxNameBytes - 8);
  for (int i = 2; taken(name); ++i) name = wanted.substr(0, kMaxNameBytes - 8) + " " + std::to_string(i);
  return name;
}

std::string light_label(const Project& project, int light) {
  return within(light, project.lights) ? project.lights[static_cast<size_t>(light)].name : "no light";
}

Edit add_to_lights(std::string name, Light light) {
  return make_edit(std::move(name), "", [light = std::move(light)](Project& target) {
    if (target.lights.size() >= kMaxLights || !light_problem(light).empty()) return;
    target.lights.push_back(light);
    const std::string wanted = light.name.empty() ? std::string(name_of(light.type)) : light.name;
    target.lights.back().name.clear();
    target.lights.back().name = unique_name(target.lights, wanted, [](const Light& other) { return other.name; });
  });
}

}  // namespace

Edit put_preset(const Project& project, int part, std::shared_ptr<const Preset> preset, const std::string& path) {
  Edit edit = edit_part(project, part, "Material", [part, preset, path](Project& target, PartState&) {
    assign_preset(target, part, *preset, path);
  });
  if (within(part, project.parts))
    edit.name = fmt::format("{} on {}", preset->name, project.parts[static_cast<size_t>(part)].name);
  return edit;
}

Edit use_own_material(const Project& project, int part) {
  return edit_part(project, part, "Own material", [part](Project& target, PartState& state) {
    // Already shown as the model has it: nothing to do, and no step.
    const MaterialInstance& shown = target.materials[static_cast<size_t>(state.material)];
    if (shown.preset.empty() && shown.model_part == state.name && shown.edits == EditLayer{}) return;
    assign_own_material(target, part);
  });
}

Edit use_material_of(const Project& project, int part, int material) {
  return edit_part(project, part, "Material", [part, material](Project& target, PartState&) {
    if (within(material, target.materials)) share_material(target, part, material);
  });
}

Edit paste_material(const Project& project, int part, const MaterialInstance& material) {
  Edit edit = edit_part(project, part, "Material", [part, material](Project& target, PartState&) {
    const auto same = std::find_if(target.materials.begin(), target.materials.end(), [&](MaterialInstance other) {
      other.name = material.name;
      return other == material;
    });
    const int index = static_cast<int>(same - target.materials.begin());
    if (same == target.materials.end()) {
      target.materials.push_back(material);
      target.materials.back().name =
          unique_name(target.materials, material.name, [](const MaterialInstance& other) { return other.name; });
    }
    share_material(target, part, index);
  });
  if (within(part, project.parts))
    edit.name = fmt::format("{} on {}", material.name, project.parts[static_cast<size_t>(part)].name);
  return edit;
}

Edit make_material_unique(const Project& project, int part) {
  return edit_part(project, part, "Material copy",
                   [part](Project& target, PartState&) { make_unique_material(target, part); });
}

Edit show_only(const Project& project, int part) {
  Edit edit;
  edit.name = within(part, project.parts) ? "Show only " + project.parts[static_cast<size_t>(part)].name
                                          : std::string("Show all parts");
  edit.change = [part](Project& target) {
    for (size_t i = 0; i < target.parts.size(); ++i) target.parts[i].visible = part < 0 || static_cast<int>(i) == part;
  };
  return edit;
}

Edit show_part(const Project& project, int part, bool visible) {
  return edit_part(project, part, visible ? "Show" : "Hide",
                   [visible](Project&, PartState& state) { state.visible = visible; });
}

Edit set_mirror(const Project& project, int part, float f0) {
  return edit_part(project, part, "Mirror",
                   [f0](Project&, PartState& state) { set_clamped(state.mirror_f0, f0, 0, 1); });
}

Edit set_texture_scale(const Project& project, int part, float scale) {
  return edit_part(project, part, "Texture scale", [scale](Project&, PartState& state) {
    set_clamped(state.texture_scale, scale, kMinTextureScale, kMaxTextureScale);
  });
}

Edit set_texture_rotation(const Project& project, int part, float radians) {
  return edit_part(project, part, "Texture rotation", [radians](Project&, PartState& state) {
    set_clamped(state.texture_rotation, radians, -kMaxTurn, kMaxTurn);
  });
}

Edit set_texture_offset(const Project& project, int part, vec2 mm) {
  return edit_part(project, part, "Texture offset", [mm](Project&, PartState& state) {
    set_clamped(state.texture_offset.x, mm.x, -kMaxTextureOffset, kMaxTextureOffset);
    set_clamped(state.texture_offset.y, mm.y, -kMaxTextureOffset, kMaxTextureOffset);
  });
}

Edit move_part(const Project& project, int part, vec3 offset) {
  return edit_part(project, part, "Place", [offset](Project&, PartState& state) {
    for (int axis = 0; axis < 3; ++axis)
      set_clamped(state.place.offset[axis], offset[axis], -kMaxCoordinate, kMaxCoordinate);
  });
}

Edit turn_part(const Project& project, int part, vec3 radians) {
  return edit_part(project, part, "Turn", [radians](Project&, PartState& state) {
    for (int axis = 0; axis < 3; ++axis) set_clamped(state.place.turn[axis], radians[axis], -kMaxTurn, kMaxTurn);
  });
}

Edit put_back(const Project& project, int part) {
  const bool one = within(part, project.parts);
  return make_edit(one ? "Put back " + project.parts[static_cast<size_t>(part)].name : "Put all parts back", "",
                   [part](Project& target) {
                     for (size_t i = 0; i < target.parts.size(); ++i)
                       if (part < 0 || part == static_cast<int>(i)) target.parts[i].place = {};
                   });
}

Edit add_light(const Project&, Light light) {
  const std::string name = "Add " + (light.name.empty() ? std::string(name_of(light.type)) : lower(light.name));
  return add_to_lights(name, std::move(light));
}

Edit duplicate_light(const Project& project, int light) {
  if (!within(light, project.lights)) return make_edit("Duplicate light", "", [](Project&) {});
  return add_to_lights("Duplicate " + light_label(project, light), project.lights[static_cast<size_t>(light)]);
}

Edit remove_light(const Project& project, int light) {
  return make_edit("Remove " + light_label(project, light), "", [light](Project& target) {
    if (within(light, target.lights)) target.lights.erase(target.lights.begin() + light);
  });
}

Edit change_light(const Project& project, int light, Light changed, const std::string& what) {
  return make_edit(fmt::format("{} of {}", what, light_label(project, light)), fmt::format("{} light {}", what, light),
                   [light, changed = std::move(changed)](Project& target) {
                     if (!within(light, target.lights)) return;
                     const Light before = std::exchange(target.lights[static_cast<size_t>(light)], changed);
                     if (!validate(target, "")) target.lights[static_cast<size_t>(light)] = before;
                   });
}

Edit set_ambient(const Project&, vec3 radiance) {
  return make_edit("Ambient light", "ambient", [radiance](Project& target) {
    if (finite(radiance)) target.ambient = glm::clamp(radiance, vec3(0), vec3(kMaxColor));
  });
}

Edit set_background(const Project&, vec3 radiance) {
  return make_edit("Background", "background", [radiance](Project& target) {
    if (finite(radiance)) target.background = glm::clamp(radiance, vec3(0), vec3(kMaxColor));
  });
}

Edit set_environment(const Project&, EnvironmentState environment) {
  return make_edit("Environment", "",
                   [environment = std::move(environment)](Project& target) { target.environment = environment; });
}

Edit remove_environment(const Project&) {
  return make_edit("Remove environment", "", [](Project& target) {
    target.environment.path.clear();
    target.environment.checksum.clear();
    target.environment.map.reset();
  });
}

Edit set_environment_rotation(const Project&, float radians) {
  return make_edit("Environment rotation", "environment rotation", [radians](Project& target) {
    set_clamped(target.environment.rotation, radians, -kMaxTurn, kMaxTurn);
  });
}

Edit set_environment_intensity(const Project&, float intensity) {
  return make_edit("Environment intensity", "environment intensity", [intensity](Project& target) {
    set_clamped(target.environment.intensity, intensity, 0, kMaxEnvironmentIntensity);
  });
}

Edit show_environment(const Project&, bool visible) {
  return make_edit(visible ? "Show environment" : "Hide environment", "",
                   [visible](Project& target) { target.environment.visible = visible; });
}

Edit keep_view(const Project&, std::string name) {
  return make_edit("Keep view", "", [name = std::move(name)](Project& target) {
    if (target.cameras.size() >= kMaxNamedCameras) return;
    NamedCamera kept{
        unique_name(target.cameras, name.empty() ? "view" : name, [](const NamedCamera& other) { return other.name; }),
        target.camera};
    target.cameras.push_back(std::move(kept));
  });
}

Edit rename_view(const Project&, int view, std::string name) {
  return make_edit("Rename view", "", [view, name = name.substr(0, kMaxNameBytes)](Project& target) {
    if (within(view, target.cameras) && !name.empty()) target.cameras[static_cast<size_t>(view)].name = name;
  });
}

Edit remove_view(const Project&, int view) {
  return make_edit("Remove view", "", [view](Project& target) {
    if (within(view, target.cameras)) target.cameras.erase(target.cameras.begin() + view);
  });
}

Edit change_settings(const Project&, RenderSettings settings, const std::string& what) {
  return make_edit(what, "settings " + what, [settings](Project& target) {
    target.settings = settings;
    target.settings.max_samples = std::clamp(settings.max_samples, 1u, kMaxSamples);
    const float goal = settings.noise_goal;
    target.settings.noise_goal = goal > 0 ? std::clamp(goal, kLeastNoiseGoal, 1.0f) : 0;
    if (!std::isfinite(settings.ao_radius)) target.settings.ao_radius = 0;
    target.settings.ao_radius = std::clamp(target.settings.ao_radius, 0.0f, kMaxCoordinate);
  });
}

Edit set_exposure(const Project&, float ev) {
  return make_edit("Exposure", "exposure",
                   [ev](Project& target) { set_clamped(target.display.exposure, ev, -kMaxExposure, kMaxExposure); });
}

Edit set_tone_map(const Project&, ToneMap tone_map) {
  return make_edit("Tone map", "", [tone_map](Project& target) { target.display.tone_map = tone_map; });
}

}  // namespace vamp
