// The rows of one light.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include "editor/model/edits_scene.h"
#include "editor/panels/apply_edit.h"
#include "editor/panels/lengths.h"
#include "editor/panels/lights_panel.h"
#include "editor/panels/subject.h"
#include "editor/widgets/controls.h"
#include "engine/project/limits.h"
#include "engine/project/studio.h"

namespace vamp::ui {

namespace {

// What a light's rows go back to: the light of that name in the model or the studio, else a new one of its type.
Light initial_light(const Project& project, const Light& light) {
  const auto named = [&](const std::vector<Light>& lights) -> const Light* {
    const auto found = std::find_if(lights.begin(), lights.end(), [&](const Light& other) {
      return other.name == light.name && other.type == light.type;
    });
    return found != lights.end() ? &*found : nullptr;
  };
  if (const Light* found = named(project.scene->lights)) return *found;
  const std::vector<Light> studio = studio_lights(project.scene->bounds);
  if (const Light* found = named(studio)) return *found;
  return new_light(project, light.type);
}

// Draws rows of one light; each edit changes one member of it.
class Rows {
 public:
  Rows(Document& document, int index)
      : document_(document),
        project_(document.project()),
        index_(index),
        light_(project_->lights[static_cast<size_t>(index)]),
        start_(light_),
        initial_(initial_light(*project_, light_)) {
    // Ranges hold still while a value is dragged.
    const std::vector<Light>& before = document.gesture_start()->lights;
    if (static_cast<size_t>(index) < before.size()) start_ = before[static_cast<size_t>(index)];
  }

  const Light& light() const { return light_; }

  void name() {
    std::string text = light_.name;
    const EditOf<std::string> event = text_row("Name", text, "What you call this light.");
    apply(event, "Name", [&](Light& changed) { changed.name = text.substr(0, kMaxNameBytes); });
  }

  void type() {
    std::array<const char*, kLightTypeCount> names{};
    for (size_t i = 0; i < names.size(); ++i) names[i] = light_word(static_cast<LightType>(i));
    int choice = static_cast<int>(light_.type);
    const EditOf<int> event =
        combo_row("Type", choice, names, -1, "Rectangles, disks and spheres give soft shadows, the others sharp ones.");
    apply(event, "Type", [&](Light& changed) {
      // Watts and watts per area do not compare: a new kind of power starts anew.
      const auto other = static_cast<LightType>(choice);
      const bool same_unit = (other == LightType::directional) == (light_.type == LightType::directional);
      if (!same_unit) changed.power = new_light(*project_, other).power;
      changed.type = other;
    });
  }

  void power() {
    const bool directional = light_.type == LightType::directional;
    const float high = std::clamp(std::max(10 * initial_.power, start_.power), 1e-3f, kMaxPower);
    const Parameter row{"Power",
                        0,
                        high,
                        initial_.power,
                        directional ? "%.4g W/u²" : "%.4g W",
                        directional ? "Irradiance of a surface that faces the light, per square unit of the model."
                                    : "Radiant power of the whole light.",
                        directional ? "W per square unit" : "W",
                        &kSquare};
    number(row, light_.power, &Light::power, 1);
  }

  void colour() {
    vec3 value = light_.color;
    const EditOf<vec3> event = colour_row("Colour", value, glm::clamp(initial_.color, vec3(0), vec3(1)),
                                          "Colour of the light; its power "
                                          "stands beside it.");
    apply(event, "Colour", [&](Light& changed) { changed.color = value; });
  }

  void place(const char* what, const char* const labels[3], vec3 Light::*member, const char* description) {
    const float mm = project_->mm_per_unit;
    for (int axis = 0; axis < 3; ++axis) {
      const Parameter row = coordinate_row(*project_, labels[axis], description, (start_.*member)[axis] * mm,
                                           (initial_.*member)[axis] * mm);
      number_row(document_, row, (light_.*member)[axis] * mm, [&](float value) {
        Light changed = light_;
        (changed.*member)[axis] = value / mm;
        return change_light(*project_, index_, changed, what);
      });
    }
  }

  void sides() {
    const float mm = project_->mm_per_unit;
    for (int axis = 0; axis < 2; ++axis) {
      const Parameter row = length_row(*project_, axis == 0 ? "Width" : "Height", "Side of the rectangle.",
                                       start_.size[axis] * mm, initial_.size[axis] * mm);
      number_row(document_, row, light_.size[axis] * mm, [&](float value) {
        Light changed = light_;
        changed.size[axis] = std::max(value / mm, kMinLength);
        return change_light(*project_, index_, changed, row.label);
      });
    }
  }

  void radius() {
    const float mm = project_->mm_per_unit;
    const Parameter row = length_row(*project_, "Radius", "Half the width of the light: larger gives softer shadows.",
                                     start_.radius * mm, initial_.radius * mm);
    number(row, light_.radius * mm, &Light::radius, 1 / mm);
  }

  void roll() {
    Parameter row = angle_row("Roll", "Turns the rectangle about its direction.", -180, 180,
                              std::clamp(initial_.roll_degrees, -180.0f, 180.0f));
    row.wraps = true;
    number(row, std::remainder(light_.roll_degrees, 360.0f), &Light::roll_degrees, 1);
  }

  void cone() {
    // The inner edge stays within the outer one.
    const Parameter outer = angle_row("Cone", "Half angle at which the light ends.", 0.1f, 90, initial_.outer_degrees);
    number_row(document_, outer, light_.outer_degrees, [&](float value) {
      Light changed = light_;
      changed.outer_degrees = value;
      changed.inner_degrees = std::min(changed.inner_degrees, value * 0.999f);
      return change_light(*project_, index_, changed, "Cone");
    });
    const Parameter inner = angle_row("Full within", "Half angle within which the light is at its full strength.", 0,
                                      89.9f, initial_.inner_degrees);
    number_row(document_, inner, light_.inner_degrees, [&](float value) {
      Light changed = light_;
      changed.inner_degrees = std::min(value, changed.outer_degrees * 0.999f);
      return change_light(*project_, index_, changed, "Inner cone");
    });
  }

 private:
  template <class T, class Change>
  void apply(const EditOf<T>& event, const char* what, Change change) {
    apply_edit(document_, event, [&] {
      Light changed = light_;
      change(changed);
      return change_light(*project_, index_, changed, what);
    });
  }
  void number(const Parameter& row, float value, float Light::*member, float factor) {
    number_row(document_, row, value, [&](float now) {
      Light changed = light_;
      changed.*member = now * factor;
      return change_light(*project_, index_, changed, row.label);
    });
  }

  Document& document_;
  ProjectPtr project_;
  int index_;
  Light light_, start_, initial_;
};

}  // namespace

Light new_light(const Project& project, LightType type) {
  // The studio's key light, in another shape.
  const std::vector<Light> studio = studio_lights(subject_bounds(project));
  Light light = studio.empty() ? Light{} : studio.front();
  light.name = light_word(type);
  light.type = type;
  light.on = true;
  light.roll_degrees = 0;
  light.radius = std::max(std::min(light.size.x, light.size.y) / 2, kMinLength);
  if (type == LightType::sphere) light.radius *= 0.5f;
  // A white matte surface that faces it then shows a radiance of about 0.8, as under the key light, which sends four
  // times as much along its axis as one that shines to all sides.
  const bool all_sides = type == LightType::point || type == LightType::spot || type == LightType::sphere;
  if (all_sides) light.power *= 4;
  if (type == LightType::directional) light.power = 0.8f * glm::pi<float>();
  return light;
}

void draw_light_rows(PanelContext& context, int light) {
  Rows rows(context.document, light);
  const LightType type = rows.light().type;
  section(rows.light().name.empty() ? "Light" : rows.light().name.c_str());
  gap(4);
  rows.name();
  rows.type();
  rows.power();
  rows.colour();
  constexpr const char* kCentre[3] = {"Centre X", "Centre Y", "Centre Z"};
  constexpr const char* kTarget[3] = {"Target X", "Target Y", "Target Z"};
  rows.place("Centre", kCentre, &Light::center, "Where the light is.");
  if (type != LightType::point && type != LightType::sphere) {
    rows.place("Target", kTarget, &Light::target, "Where the light shines to.");
  }
  if (type == LightType::rect) {
    rows.sides();
    rows.roll();
  }
  if (type == LightType::disk || type == LightType::sphere) rows.radius();
  if (type == LightType::spot) rows.cone();
  gap(2);
}

}  // namespace vamp::ui
