#include "editor/panels/parts_panel.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/trigonometric.hpp>
#include <utility>

#include "editor/model/edits_scene.h"
#include "editor/panels/apply_edit.h"
#include "editor/panels/fit_figures.h"
#include "editor/panels/lengths.h"
#include "editor/panels/material_drop.h"
#include "editor/panels/part_menu.h"
#include "editor/panels/part_place.h"
#include "editor/panels/view_commands.h"
#include "editor/widgets/actions.h"
#include "editor/widgets/controls.h"
#include "editor/widgets/hover.h"
#include "editor/widgets/icons.h"
#include "editor/widgets/theme.h"
#include "engine/project/limits.h"

namespace vamp::ui {

namespace {

constexpr float kRowsHeight = 250;  // of the selected part's rows, at 96 dpi
constexpr size_t kSearchFrom = 12;  // fewer parts are seen at a glance

const PartState& part_of(const Project& project, int part) { return project.parts[static_cast<size_t>(part)]; }

}  // namespace

void PartsPanel::draw(PanelContext& context) {
  const ProjectPtr project = context.document.project();
  context.selection = valid_selection(*project, context.selection);
  if (project->parts.size() > kSearchFrom) {
    search_field("search", search_, "Search parts and materials");
    gap(2);
  } else {
    search_.clear();
  }
  if (!project->scene->notes.empty()) draw_notes(*project->scene);
  // The list scrolls on its own, so that the selected part's rows stay in sight.
  const float room = ImGui::GetContentRegionAvail().y, line = px(22);
  const float list = static_cast<float>(project->parts.size()) * line + px(6);
  const bool rows = context.selection.part >= 0;
  const float height = rows ? std::min(list, std::max(room - px(kRowsHeight), room * 0.5f)) : room;
  resized_ = std::exchange(height_, height) != height;
  if (ImGui::BeginChild("list", ImVec2(0, std::max(height, 3 * line)))) draw_table(context);
  ImGui::EndChild();
  if (context.selection.part >= 0) draw_part(context, context.selection.part);
}

void PartsPanel::draw_table(PanelContext& context) {
  const ProjectPtr project = context.document.project();
  ImGui::PushStyleVar(ImGuiStyleVar_CellPadding, ImVec2(px(4), px(1)));
  if (ImGui::BeginTable("parts", 3)) {
    ImGui::TableSetupColumn("eye", ImGuiTableColumnFlags_WidthFixed, px(20));
    ImGui::TableSetupColumn("part");
    ImGui::TableSetupColumn("material");
    for (int i = 0; i < static_cast<int>(project->parts.size()); ++i) {
      const PartState& part = part_of(*project, i);
      const MaterialInstance* material = find_material(*project, part.material);
      const std::string shown = material != nullptr ? material->name : "";
      if (!search_.empty() && Actions::match(search_, part.name) == 0 && Actions::match(search_, shown) == 0) continue;
      const bool selected = context.selection.part == i;
      ImGui::TableNextRow();
      ImGui::TableNextColumn();
      ImGui::PushID(i);
      if (row_selectable("##row", selected, px(20)) && !selected) context.selection = select_part(*project, i);
      accept_material(context, i);
      if (ImGui::IsItemHovered() && ImGui::IsMouseDoubleClicked(0)) fit_part(context, i);
      if (ImGui::IsItemHovered() && ImGui::IsMouseReleased(1)) {
        context.selection = select_part(*project, i);
        ImGui::OpenPopup("##menu");
      }
      // It was selected in the picture, or the list has become shorter to make room for its rows.
      if (selected && (shown_ != i || resized_)) ImGui::SetScrollHereY();
      if (icon_button("##eye", part.visible ? Icon::eye : Icon::eye_closed,
                      part.visible ? "Hide the part" : "Show the part", part.visible)) {
        context.document.edit(show_part(*project, i, !part.visible));
      }
      ImGui::TableNextColumn();
      cell_text(part.name.c_str(), part.visible ? 0 : theme().dim);
      ImGui::TableNextColumn();
      cell_text(shown.c_str(), selected ? 0 : theme().dim);
      if (ImGui::BeginPopup("##menu")) {
        part_menu(context, i);
        ImGui::EndPopup();
      }
      ImGui::PopID();
    }
    ImGui::EndTable();
  }
  ImGui::PopStyleVar();
  shown_ = context.selection.part;
}

// What the importer left out or made up, for those who wonder why the shoe looks different elsewhere.
void PartsPanel::draw_notes(const Scene& scene) {
  const size_t count = scene.notes.size();
  const std::string text = fmt::format("{} {} on the model", count, count == 1 ? "remark" : "remarks");
  ImGui::PushStyleColor(ImGuiCol_Text, theme().changed);
  if (ImGui::Selectable(text.c_str())) ImGui::OpenPopup("##notes");
  ImGui::PopStyleColor();
  hover_text("What of the model's file is not shown, or was made up");
  if (!ImGui::BeginPopup("##notes")) return;
  ImGui::PushTextWrapPos(px(420));
  for (const std::string& note : scene.notes) ImGui::TextUnformatted(note.c_str());
  ImGui::PopTextWrapPos();
  ImGui::EndPopup();
}

void PartsPanel::draw_part(PanelContext& context, int part) {
  Document& document = context.document;
  const ProjectPtr project = document.project();
  const PartState& state = part_of(*project, part);
  gap(4);
  section(state.name.c_str());
  gap(2);
  if (const MaterialInstance* material = find_material(*project, state.material)) {
    const std::string text = fmt::format("{}{}", material->name, material->preset.empty() ? " (of the model)" : "");
    info_row("Material", text.c_str(), "What the part shows: a preset, or what the model file says");
    const vec2 size = material->fit->size_mm() * state.texture_scale;
    const std::string size_text = fmt::format("{:.4g} × {:.4g} mm", size.x, size.y);
    info_row("Texture", size_text.c_str(), "The size of one repeat on the part");
  }
  number_row(document,
             {"Scale", kMinTextureScale, kMaxTextureScale, 1, "%.2f ×",
              "Size of the texture on the part over its physical size.", "times", &kLog},
             state.texture_scale, [&](float value) { return set_texture_scale(*project, part, value); });
  const float turn = std::remainder(glm::degrees(state.texture_rotation), 360.0f);
  Parameter rotation = angle_row("Rotation", "Turns the texture on the part.", -180, 180, 0);
  rotation.wraps = true;
  number_row(document, rotation, turn,
             [&](float value) { return set_texture_rotation(*project, part, glm::radians(value)); });
  const vec2 offset = state.texture_offset;
  const auto offset_row = [&](const char* label, const char* description, int axis) {
    const vec2 reach = find_material(*project, state.material)->fit->size_mm();
    const float high = std::max(
        {reach[axis], 1.0f, std::abs(document.gesture_start()->parts[static_cast<size_t>(part)].texture_offset[axis])});
    number_row(document, {label, -high, high, 0, "%.1f mm", description, "mm"}, offset[axis], [&](float value) {
      vec2 moved = offset;
      moved[axis] = value;
      return set_texture_offset(*project, part, moved);
    });
  };
  if (find_material(*project, state.material) != nullptr) {
    offset_row("Offset U", "Moves the texture along its first direction.", 0);
    offset_row("Offset V", "Moves the texture along its second direction.", 1);
  }
  number_row(document,
             {"Mirror F0", 0, 1, 0, "%.3f",
              "Mirror reflection seen head-on: 0 is none, 0.04 a lacquer, 1 a perfect mirror.", "share", &kSquare},
             state.mirror_f0, [&](float value) { return set_mirror(*project, part, value); });
  gap(2);
  if (!section("Place", &place_open_)) return;
  gap(4);
  draw_part_place(context, part);
}

}  // namespace vamp::ui
