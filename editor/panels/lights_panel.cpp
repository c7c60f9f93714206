#include "editor/panels/lights_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "editor/model/edits_scene.h"
#include "editor/widgets/controls.h"
#include "editor/widgets/hover.h"
#include "editor/widgets/icons.h"
#include "editor/widgets/theme.h"

namespace vamp::ui {

namespace {

constexpr std::array<LightType, kLightTypeCount> kTypes{LightType::rect,  LightType::disk, LightType::sphere,
                                                        LightType::point, LightType::spot, LightType::directional};

}  // namespace

const char* light_word(LightType type) {
  constexpr std::array<const char*, kLightTypeCount> kWords{"Point",     "Spot", "Directional",
                                                            "Rectangle", "Disk", "Sphere"};
  return kWords[static_cast<size_t>(type)];
}

void LightsPanel::draw(PanelContext& context) {
  const auto count = static_cast<int>(context.document.project()->lights.size());
  if (count > count_ && count_ >= 0) light_ = count - 1;  // a new one, from here or from the menu
  count_ = count;
  light_ = std::clamp(light_, count > 0 ? 0 : -1, count - 1);
  draw_list(context);
  draw_buttons(context);
  if (light_ >= 0 && static_cast<size_t>(light_) < context.document.project()->lights.size()) {
    ImGui::PushID(light_);
    draw_light_rows(context, light_);
    ImGui::PopID();
  }
  draw_surroundings(context);
}

void LightsPanel::draw_list(PanelContext& context) {
  const ProjectPtr project = context.document.project();
  if (project->lights.empty()) {
    ImGui::TextDisabled("No light");
    return;
  }
  ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, ImVec2(px(4), px(1)));
  if (ImGui::BeginTable("lights", 3)) {
    ImGui::TableSetupColumn("on", ImGuiTableColumnFlags_WidthFixed, px(20));
    ImGui::TableSetupColumn("name");
    ImGui::TableSetupColumn("power");
    for (int i = 0; i < static_cast<int>(project->lights.size()); ++i) {
      const Light& light = project->lights[static_cast<size_t>(i)];
      ImGui::TableNextRow();
      ImGui::TableNextColumn();
      ImGui::PushID(i);
      if (row_selectable("##row", light_ == i, px(20))) light_ = i;
      if (icon_button("##on", light.on ? Icon::eye : Icon::eye_closed, light.on ? "Switch off" : "Switch on",
                      light.on)) {
        Light changed = light;
        changed.on = !light.on;
        context.document.edit(change_light(*project, i, changed, light.on ? "Switch off" : "Switch on"));
      }
      ImGui::TableNextColumn();
      const std::string name = light.name.empty() ? fmt::format("light {}", i + 1) : light.name;
      cell_text(name.c_str(), light.on ? 0 : theme().dim);
      ImGui::TableNextColumn();
      const std::string power = fmt::format("{} · {:.4g} {}", light_word(light.type), light.power,
                                            light.type == LightType::directional ? "W/unit²" : "W");
      cell_text(power.c_str(), light_ == i ? 0 : theme().dim);
      ImGui::PopID();
    }
    ImGui::EndTable();
  }
  ImGui::PopStyleVar();
}

void LightsPanel::draw_buttons(PanelContext& context) {
  const ProjectPtr project = context.document.project();
  const bool full = project->lights.size() >= kMaxLights;
  gap(4);
  ImGui::BeginDisabled(full);
  if (ImGui::Button("Add ▾")) ImGui::OpenPopup("##add");
  ImGui::EndDisabled();
  if (full) hover_text(fmt::format("There may be {} lights", kMaxLights).c_str());
  if (ImGui::BeginPopup("##add")) {
    for (const LightType type : kTypes) {
      if (ImGui::MenuItem(light_word(type))) context.document.edit(add_light(*project, new_light(*project, type)));
    }
    ImGui::EndPopup();
  }
  ImGui::SameLine();
  ImGui::BeginDisabled(light_ < 0 || full);
  if (ImGui::Button("Duplicate")) context.document.edit(duplicate_light(*project, light_));
  ImGui::EndDisabled();
  ImGui::SameLine();
  ImGui::BeginDisabled(light_ < 0);
  if (ImGui::Button("Remove")) context.document.edit(remove_light(*project, light_));
  ImGui::EndDisabled();
  gap(2);
}

}  // namespace vamp::ui
