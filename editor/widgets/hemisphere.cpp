#include "editor/widgets/hemisphere.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

#include "editor/widgets/hover.h"
#include "editor/widgets/theme.h"

namespace vamp::ui {

namespace {

constexpr float kDegrees = 57.29577951f;

// The disk shows the sine of the tilt, as a sphere seen from above does.
ImVec2 on_disk(const Tilt& d, float radius) {
  const float r = radius * std::sin(d.tilt / kDegrees);
  return ImVec2(r * std::cos(d.azimuth / kDegrees), -r * std::sin(d.azimuth / kDegrees));
}

Tilt from_disk(ImVec2 offset, float radius, float max_tilt, float old_azimuth) {
  const float r = std::sqrt(offset.x * offset.x + offset.y * offset.y) / radius;
  Tilt d;
  d.tilt = std::min(std::asin(std::min(r, 1.0f)) * kDegrees, max_tilt);
  d.azimuth = r > 1e-4f ? std::atan2(-offset.y, offset.x) * kDegrees : old_azimuth;
  if (d.azimuth < 0) d.azimuth += 360;
  return d;
}

// The handle's place while it is dragged, from the centre: it must not drift by rounding or at the limits.
ImVec2 g_handle;

bool drag_disk(const char* id, ImVec2 centre, float radius, float max_tilt, Tilt& direction, bool locked) {
  ImGui::SetCursorScreenPos(ImVec2(centre.x - radius, centre.y - radius));
  ImGui::BeginDisabled(locked);
  ImGui::InvisibleButton(id, ImVec2(2 * radius, 2 * radius));
  ImGui::EndDisabled();
  const ImGuiIO& io = ImGui::GetIO();
  const bool held = ImGui::IsItemActive();
  if (ImGui::IsItemActivated()) g_handle = on_disk(direction, radius);
  if (held && (io.MouseDelta.x != 0 || io.MouseDelta.y != 0) && ImGui::IsMouseDragging(0, px(2))) {
    const float speed = io.KeyShift ? 0.1f : 1.0f;
    g_handle.x += io.MouseDelta.x * speed;
    g_handle.y += io.MouseDelta.y * speed;
    direction = from_disk(g_handle, radius, max_tilt, direction.azimuth);
  }
  return held;
}

void draw_disk(ImVec2 centre, float radius, float max_tilt, const Tilt& direction, bool changed, bool active) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  // A ball lit from above, as nested disks: neutral, so that it is no colour among the colours.
  const int rings = 5;
  for (int i = 0; i < rings; ++i) {
    const float t = static_cast<float>(i) / rings;
    const int grey = 58 + static_cast<int>(34 * t);
    list.AddCircleFilled(ImVec2(centre.x, centre.y - 0.25f * radius * t), radius * (1 - 0.75f * t),
                         ImGui::GetColorU32(IM_COL32(grey, grey, grey, 255)), 48);
  }
  const ImU32 lines = ImGui::GetColorU32(IM_COL32(124, 124, 124, 255));
  list.AddCircle(centre, radius, lines, 64);
  list.AddLine(ImVec2(centre.x - radius, centre.y), ImVec2(centre.x + radius, centre.y), lines);
  list.AddLine(ImVec2(centre.x, centre.y - radius), ImVec2(centre.x, centre.y + radius), lines);
  if (max_tilt < 89) {
    list.AddCircle(centre, radius * std::sin(max_tilt / kDegrees), ImGui::GetColorU32(IM_COL32(92, 92, 92, 255)), 48);
  }
  const ImVec2 at = on_disk(direction, radius);
  const ImVec2 dot(centre.x + at.x, centre.y + at.y);
  const ImU32 colour = changed ? theme().changed : theme().text;
  list.AddLine(centre, dot, ImGui::GetColorU32(IM_COL32(200, 200, 200, 110)));
  list.AddCircleFilled(dot, px(active ? 6 : 4.5f), ImGui::GetColorU32(colour), 20);
  list.AddCircle(dot, px(active ? 6 : 4.5f), ImGui::GetColorU32(IM_COL32(30, 30, 30, 255)), 20);
}

// A gesture of one of the two rows as a gesture of the direction.
void merge(const EditOf<float>& part, float Tilt::*member, const Tilt& now, EditOf<Tilt>& edit) {
  if (!part) return;
  edit.event = part.event;
  edit.before = now;
  edit.before.*member = part.before;
}

}  // namespace

vec3 direction_from_tilt(const Tilt& d) {
  const float s = std::sin(d.tilt / kDegrees);
  return vec3(s * std::cos(d.azimuth / kDegrees), s * std::sin(d.azimuth / kDegrees), std::cos(d.tilt / kDegrees));
}

Tilt tilt_from_direction(const vec3& n) {
  Tilt d;
  d.tilt = std::atan2(std::sqrt(n.x * n.x + n.y * n.y), n.z) * kDegrees;
  d.azimuth = n.x == 0 && n.y == 0 ? 0 : std::atan2(n.y, n.x) * kDegrees;
  if (d.azimuth < 0) d.azimuth += 360;
  return d;
}

EditOf<Tilt> direction_row(const char* label, Tilt& direction, const Tilt& initial, float max_tilt,
                           const char* description, const RowState& state) {
  const Tilt old = direction;
  EditOf<Tilt> edit;
  RowColumns row = next_row();
  ImGui::PushID(label);
  const float radius = px(48);
  const ImVec2 centre(row.left + radius + px(2), row.top + radius + px(6));
  const bool held = drag_disk("##disk", centre, radius, max_tilt, direction, state.locked);
  const bool over_disk = ImGui::IsItemHovered();
  const ImGuiID disk_id = ImGui::GetItemID();
  const bool changed = direction.tilt != initial.tilt || direction.azimuth != initial.azimuth;
  draw_disk(centre, radius, max_tilt, direction, changed, held);
  if (tooltip_due(disk_id, over_disk)) show_tooltip(label, description, "Drag the handle, Shift for fine steps");
  edit.event = track_edit(ImGui::GetID("##edit"), held, {&old.tilt, 2}, {&direction.tilt, 2}, {&edit.before.tilt, 2});

  // Caption and rows to the right of the disk.
  row.left = centre.x + radius + px(14);
  row.top += px(16);
  row.control = row.left + px(64);
  RowColumns caption = row;
  caption.control = row.number_end;
  row_label(caption, label, state.locked);
  Parameter tilt;
  tilt.label = "Tilt";
  tilt.high = max_tilt;
  tilt.initial = initial.tilt;
  tilt.format = "%.1f°";
  tilt.unit = "degrees";
  tilt.description = "How far the direction leans from the surface normal.";
  Parameter azimuth = tilt;
  azimuth.label = "Azimuth";
  azimuth.high = 360;
  azimuth.initial = initial.azimuth;
  azimuth.description = "Where it leans to, counter-clockwise from the tangent direction.";
  azimuth.wraps = true;
  row.top += row.height;
  row_label(row, tilt.label, state.locked);
  merge(parameter_control(tilt, direction.tilt, row, state), &Tilt::tilt, direction, edit);
  row.top += row.height;
  row_label(row, azimuth.label, state.locked);
  merge(parameter_control(azimuth, direction.azimuth, row, state), &Tilt::azimuth, direction, edit);
  ImGui::PopID();

  row.left = centre.x - radius - px(2);
  row.top = centre.y - radius - px(6);
  row.height = 2 * radius + px(12);
  end_row(row);
  return edit;
}

}  // namespace vamp::ui
