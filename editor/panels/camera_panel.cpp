#include "editor/panels/camera_panel.h"

#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "editor/model/edits_scene.h"
#include "editor/panels/apply_edit.h"
#include "editor/panels/lengths.h"
#include "editor/panels/view_commands.h"
#include "editor/widgets/controls.h"
#include "editor/widgets/hover.h"
#include "editor/widgets/icons.h"
#include "editor/widgets/theme.h"
#include "engine/project/limits.h"

namespace vamp::ui {

void CameraPanel::draw(PanelContext& context) {
  draw_camera(context);
  draw_views(context);
}

void CameraPanel::draw_camera(PanelContext& context) {
  const ProjectPtr project = context.document.project();
  const float mm = project->mm_per_unit;
  const Camera& initial = context.opened_camera;
  Camera camera = project->camera;
  bool moved = false;
  const auto place = [&](const char* const labels[3], vec3 Camera::*member, const char* description) {
    for (int axis = 0; axis < 3; ++axis) {
      float value = (camera.*member)[axis] * mm;
      const Parameter row = coordinate_row(*project, labels[axis], description, value, (initial.*member)[axis] * mm);
      // Also while it is taken back: the widget then gives the value from before.
      if (parameter_row(row, value)) {
        (camera.*member)[axis] = value / mm;
        moved = true;
      }
    }
  };
  gap(-6);
  section("Camera");
  gap(4);
  constexpr const char* kEye[3] = {"Eye X", "Eye Y", "Eye Z"};
  constexpr const char* kTarget[3] = {"Target X", "Target Y", "Target Z"};
  place(kEye, &Camera::eye, "Where the camera stands.");
  place(kTarget, &Camera::target, "What the camera looks at and turns about.");
  float fov = camera.fov_degrees;
  const Parameter angle =
      angle_row("FOV", "Field of view: the vertical angle.", kMinFovDegrees, kMaxFovDegrees, initial.fov_degrees);
  if (parameter_row(angle, fov)) {
    camera.fov_degrees = fov;
    moved = true;
  }
  if (moved && camera.eye != camera.target) context.document.set_camera(camera);
  gap(4);
  draw_standard_views(context);
}

void CameraPanel::draw_standard_views(PanelContext& context) {
  const float room = ImGui::GetContentRegionAvail().x, spacing = ImGui::GetStyle().ItemSpacing.x;
  const int columns = room < px(320) ? 2 : 3;
  const float width = (room - static_cast<float>(columns - 1) * spacing) / static_cast<float>(columns);
  int index = 0;
  const auto button = [&](const char* label, const char* tooltip) {
    if (index++ % columns != 0) ImGui::SameLine();
    const bool pressed = ImGui::Button(label, ImVec2(width, 0));
    hover_text(tooltip);
    return pressed;
  };
  for (const StandardViewRow& row : kStandardViews) {
    if (button(row.label, row.tooltip)) standard_view(context, row.view);
  }
  if (button("Fit model", "The whole model fits into the picture (F when nothing is selected)")) fit_view(context);
  ImGui::BeginDisabled(context.selection.part < 0);
  if (button("Fit part", "The selected part fits into the picture (F)")) fit_part(context, context.selection.part);
  ImGui::EndDisabled();
  gap(2);
}

void CameraPanel::draw_views(PanelContext& context) {
  Document& document = context.document;
  const ProjectPtr project = document.project();
  section("Kept views");
  gap(4);
  const float button = px(60);
  ImGui::SetNextItemWidth(std::max(px(40), ImGui::GetContentRegionAvail().x - button - px(6)));
  const bool entered =
      ImGui::InputTextWithHint("##name", "Name of this view", &name_, ImGuiInputTextFlags_EnterReturnsTrue);
  ImGui::SameLine();
  const bool full = project->cameras.size() >= kMaxNamedCameras;
  ImGui::BeginDisabled(full);
  if ((ImGui::Button("Keep", ImVec2(button, 0)) || entered) && !full) {
    document.edit(keep_view(*project, name_));
    name_.clear();
  }
  ImGui::EndDisabled();
  hover_text("Keeps the view as it is now; the project saves it");
  for (int i = 0; i < static_cast<int>(project->cameras.size()); ++i) draw_view(context, i);
}

void CameraPanel::draw_view(PanelContext& context, int index) {
  Document& document = context.document;
  const ProjectPtr project = document.project();
  const NamedCamera& view = project->cameras[static_cast<size_t>(index)];
  Camera here = project->camera;
  here.name = view.camera.name;
  const bool shown = here == view.camera;
  const RowColumns row = next_row();
  const float middle = std::floor(row.top + row.height / 2);
  ImGui::PushID(index);
  ImGui::SetCursorScreenPos(ImVec2(row.left, middle - px(11)));
  if (shown) ImGui::PushStyleColor(ImGuiCol_Button, theme().accent);
  if (ImGui::Button("Go to", ImVec2(row.control - row.left - px(6), px(22)))) document.set_camera(view.camera);
  if (shown) ImGui::PopStyleColor();
  const TypedField name =
      typed_field("##name", ImVec2(row.control, middle - px(11)), ImVec2(row.number_end, middle + px(11)),
                  view.name.c_str(), view.name, false, false, false);
  if (name.hovered) hover_text("Double-click to rename");
  if (name.entered) document.edit(rename_view(*project, index, name.typed));
  ImGui::SetCursorScreenPos(ImVec2(row.reset, middle - px(9)));
  if (icon_button("##delete", Icon::close, "Delete the view")) document.edit(remove_view(*project, index));
  ImGui::PopID();
  end_row(row);
}

}  // namespace vamp::ui
