#pragma once
// What a designer does to parts, lights, views and settings, as named edits for Document::edit. Values out of range are
// clamped (engine/project/limits.h), those that are not finite are left out.
#include <memory>
#include <string>

#include "editor/model/document.h"

namespace vamp {

// ---- Parts
Edit put_preset(const Project& project, int part, std::shared_ptr<const Preset> preset, const std::string& path);
Edit use_own_material(const Project& project, int part);
Edit use_material_of(const Project& project, int part, int material);
// A material that was copied from a part, as it was then: parts that get the same one share it.
Edit paste_material(const Project& project, int part, const MaterialInstance& material);
Edit make_material_unique(const Project& project, int part);
Edit show_part(const Project& project, int part, bool visible);
Edit show_only(const Project& project, int part);  // all others are hidden; -1: all are shown
Edit set_mirror(const Project& project, int part, float f0);
Edit set_texture_scale(const Project& project, int part, float scale);
Edit set_texture_rotation(const Project& project, int part, float radians);
Edit set_texture_offset(const Project& project, int part, vec2 mm);
Edit move_part(const Project& project, int part, vec3 offset);  // scene units from where the model has it
Edit turn_part(const Project& project, int part, vec3 radians);
Edit put_back(const Project& project, int part);  // where the model has it; -1: all parts

// ---- Lights
Edit add_light(const Project& project, Light light);  // no more than kMaxLights; the name is made unique
Edit duplicate_light(const Project& project, int light);
Edit remove_light(const Project& project, int light);
// `what` changed in the light, for the history: "Power". A light that could not shine is left as it was.
Edit change_light(const Project& project, int light, Light changed, const std::string& what);
Edit set_ambient(const Project& project, vec3 radiance);
Edit set_background(const Project& project, vec3 radiance);
// The map is loaded by the caller: assign_environment on a copy, on a worker thread if it is large.
Edit set_environment(const Project& project, EnvironmentState environment);
Edit remove_environment(const Project& project);
Edit set_environment_rotation(const Project& project, float radians);
Edit set_environment_intensity(const Project& project, float intensity);
Edit show_environment(const Project& project, bool visible);

// ---- Views and settings
Edit keep_view(const Project& project, std::string name);  // the camera as it stands; the name is made unique
Edit rename_view(const Project& project, int view, std::string name);
Edit remove_view(const Project& project, int view);
Edit change_settings(const Project& project, RenderSettings settings, const std::string& what);
Edit set_exposure(const Project& project, float ev);
Edit set_tone_map(const Project& project, ToneMap tone_map);

}  // namespace vamp
