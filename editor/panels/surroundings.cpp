// Ambient light, occlusion, environment, background.
#include <algorithm>
#include <cmath>
#include <filesystem>
#include <glm/trigonometric.hpp>

#include "editor/model/edits_scene.h"
#include "editor/panels/apply_edit.h"
#include "editor/panels/lengths.h"
#include "editor/panels/lights_panel.h"
#include "editor/widgets/controls.h"
#include "engine/project/limits.h"
#include "engine/project/studio.h"

namespace vamp::ui {

namespace {

float largest(const vec3& c) { return std::max({c.x, c.y, c.z}); }

// A radiance as level and colour. A level of 0 has no colour of its own: white takes its place.
template <class Make>
void radiance_rows(Document& document, const char* level_label, const char* colour_label, const char* description,
                   const vec3& radiance, const vec3& start, const vec3& initial, Make make) {
  const float level = largest(radiance), from = largest(start);
  const vec3 colour = from > 0 ? start / from : vec3(1);
  const float high = std::clamp(std::max({2.0f, from, 4 * largest(initial)}), 2.0f, kMaxColor);
  number_row(document,
             {level_label, 0, high, largest(initial), "%.3f", description, "W per steradian and square unit", &kSquare},
             level, [&](float value) { return make(colour * value); });
  vec3 hue = level > 0 ? radiance / level : vec3(1);
  RowState state;
  state.locked = level <= 0;
  const EditOf<vec3> picked =
      colour_row(colour_label, hue, largest(initial) > 0 ? initial / largest(initial) : vec3(1), description, state);
  apply_edit(document, picked, [&] { return make(largest(hue) > 0 ? hue * (level / largest(hue)) : radiance); });
}

void draw_environment(PanelContext& context) {
  Document& document = context.document;
  const ProjectPtr project = document.project();
  const EnvironmentState& environment = project->environment;
  section("Environment");
  gap(4);
  const bool has = environment.map != nullptr || !environment.path.empty();
  const std::string name = has ? std::filesystem::path(environment.path).filename().string() : "none";
  info_row("Map", name.c_str(), environment.path.c_str());
  ImGui::BeginDisabled(!context.choose_environment);
  if (ImGui::Button("Choose…")) context.choose_environment();
  ImGui::EndDisabled();
  ImGui::SameLine();
  ImGui::BeginDisabled(!has);
  if (ImGui::Button("Remove##environment")) document.edit(remove_environment(*project));
  ImGui::EndDisabled();
  gap(2);
  if (!has) return;
  Parameter turn = angle_row("Rotation", "Turns the environment about the vertical.", -180, 180, 0);
  turn.wraps = true;
  number_row(document, turn, std::remainder(glm::degrees(environment.rotation), 360.0f),
             [&](float value) { return set_environment_rotation(*project, glm::radians(value)); });
  const float high = std::max(10.0f, document.gesture_start()->environment.intensity);
  number_row(document, {"Intensity", 0, high, 1, "%.2f ×", "Multiplies the light of the map.", "times", &kSquare},
             environment.intensity, [&](float value) { return set_environment_intensity(*project, value); });
  bool visible = environment.visible;
  const EditOf<bool> shown =
      toggle_row("Visible", visible, true, "Whether the map is seen behind the model; it lights the model either way.");
  apply_edit(document, shown, [&] { return show_environment(*project, visible); });
}

}  // namespace

void draw_surroundings(PanelContext& context) {
  Document& document = context.document;
  const ProjectPtr project = document.project();
  const ProjectPtr start = document.gesture_start();
  const Scene& scene = *project->scene;
  const float mm = project->mm_per_unit;
  section("Ambient light");
  gap(4);
  radiance_rows(document, "Level", "Colour", "Light from all sides, held off by what stands near.", project->ambient,
                start->ambient, scene.ambient.value_or(vec3(kStudioAmbient)),
                [&](const vec3& radiance) { return set_ambient(*project, radiance); });
  const float initial = scene.ao_radius.value_or(0) * mm;
  const float high = std::max({4 * model_radius_mm(*project), start->settings.ao_radius * mm, initial});
  number_row(document,
             {"AO radius", 0, high, initial, "%.1f mm",
              "How near a thing must be to hold off ambient light; 0 for any distance.", "mm", &kSquare},
             project->settings.ao_radius * mm, [&](float value) {
               RenderSettings settings = project->settings;
               settings.ao_radius = value / mm;
               return change_settings(*project, settings, "AO radius");
             });
  gap(2);
  draw_environment(context);
  gap(2);
  section("Background");
  gap(4);
  ImGui::PushID("background");
  radiance_rows(document, "Level", "Colour", "What is seen behind the model where no environment is shown.",
                project->background, start->background, vec3(kStudioBackground),
                [&](const vec3& radiance) { return set_background(*project, radiance); });
  ImGui::PopID();
}

}  // namespace vamp::ui
