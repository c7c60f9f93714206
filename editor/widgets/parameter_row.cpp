// The number with its slider.
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "editor/widgets/hover.h"
#include "editor/widgets/places.h"
#include "editor/widgets/row.h"
#include "editor/widgets/theme.h"

namespace vamp::ui {

namespace {

// Where the pointer's travel stands between frames: whole numbers and clamped ends must not lose it.
struct Drag {
  ImGuiID id = 0;
  float t = 0;
};
Drag g_drag;

std::string shown_text(const Parameter& parameter, float value) {
  char text[64];
  ImFormatString(text, sizeof text, parameter.format, static_cast<double>(value));
  // What is shown as zero has no sign: "-0.0 mm" looks like something.
  const bool zero = text[0] == '-' && std::string_view(text).find_first_of("123456789") == std::string_view::npos;
  return zero ? text + 1 : text;
}

// Moves the value by the pointer's way since the last frame; `width` pixels are the whole range.
void drag_by_pointer(const Parameter& parameter, float& value, ImGuiID id, float width) {
  const ImGuiIO& io = ImGui::GetIO();
  if (g_drag.id != id) g_drag = {id, parameter.mapping->to_slider(value, parameter.low, parameter.high)};
  if (!ImGui::IsMouseDragging(0, px(2)) || io.MouseDelta.x == 0) return;
  g_drag.t += io.MouseDelta.x / std::max(width, 1.0f) * (io.KeyShift ? 0.1f : 1.0f);
  if (parameter.wraps) {
    g_drag.t -= std::floor(g_drag.t);
  } else {
    // A little travel past the end is remembered, so that the pointer and the bar meet again on the way back.
    g_drag.t = std::clamp(g_drag.t, -0.05f, 1.05f);
  }
  const float t = std::clamp(g_drag.t, 0.0f, 1.0f);
  value = admit(parameter, parameter.mapping->from_slider(t, parameter.low, parameter.high));
}

void draw_slider(const Parameter& parameter, float value, const ImRect& bar, bool hovered, bool held, bool mixed) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float rounding = px(2);
  const auto place = [&](float v) {
    const float t = parameter.mapping->to_slider(admit(parameter, v), parameter.low, parameter.high);
    return std::floor(bar.Min.x + std::clamp(t, 0.0f, 1.0f) * bar.GetWidth());
  };
  list.AddRectFilled(bar.Min, bar.Max, ImGui::GetColorU32(theme().field), rounding);
  if (!mixed && place(value) > bar.Min.x) {
    const ImU32 fill = held ? theme().fill_active : theme().fill;
    list.AddRectFilled(bar.Min, ImVec2(place(value), bar.Max.y), ImGui::GetColorU32(fill), rounding);
  }
  const ImU32 border = hovered || held ? IM_COL32(100, 100, 100, 255) : theme().field_border;
  list.AddRect(bar.Min, bar.Max, ImGui::GetColorU32(border), rounding);
  // The default, unless it is at an end where it would say nothing.
  if (parameter.initial > parameter.low && parameter.initial < parameter.high) {
    const float x = place(parameter.initial);
    list.AddRectFilled(ImVec2(x, bar.Min.y - px(2)), ImVec2(x + px(1), bar.Max.y + px(2)),
                       ImGui::GetColorU32(theme().tick));
  }
}

void parameter_tooltip(const Parameter& parameter) {
  const std::string unit = *parameter.unit != 0 ? std::string(" ") + parameter.unit : std::string();
  const std::string footer = "Range " + print_number(parameter.low) + " – " + print_number(parameter.high) + unit +
                             ", default " + print_number(parameter.initial) + unit +
                             "\nDrag, Shift for fine steps; double-click to type";
  show_tooltip(parameter.label, parameter.description, footer.c_str());
}

enum class MenuChoice { none, reset, paste, type };

MenuChoice context_menu(const Parameter& parameter, float value, bool changed, std::optional<float>& pasted) {
  MenuChoice choice = MenuChoice::none;
  if (!ImGui::BeginPopup("##menu")) return choice;
  const std::string reset = "Reset to " + shown_text(parameter, parameter.initial);
  if (ImGui::MenuItem(reset.c_str(), nullptr, false, changed)) choice = MenuChoice::reset;
  if (ImGui::MenuItem("Type a value", "double-click")) choice = MenuChoice::type;
  ImGui::Separator();
  if (ImGui::MenuItem("Copy")) ImGui::SetClipboardText(print_number(value).c_str());
  const char* clipboard = ImGui::GetClipboardText();
  pasted = parse_number(clipboard != nullptr ? clipboard : "");
  if (ImGui::MenuItem("Paste", nullptr, false, pasted.has_value())) choice = MenuChoice::paste;
  ImGui::EndPopup();
  return choice;
}

}  // namespace

EditOf<float> parameter_control(const Parameter& parameter, float& value, const RowColumns& row,
                                const RowState& state) {
  EditOf<float> edit;
  edit.before = value;
  const float old = value;
  ImGuiWindow* window = ImGui::GetCurrentWindow();
  if (window->SkipItems) return edit;
  ImGui::PushID(parameter.label);
  const float middle = std::floor(row.top + row.height / 2);
  bool held = false;
  bool hovered = false;
  static ImGuiID type_next = 0;  // asked for by the menu in the last frame
  const ImGuiID number_id = window->GetID("##number");
  bool start_typing = std::exchange(type_next, type_next == number_id ? 0 : type_next) == number_id;

  // The slider. Not a stop for the keyboard: the number beside it is.
  const ImRect bar(ImVec2(row.control, middle - px(7)), ImVec2(row.control_end, middle + px(7)));
  const ImGuiID bar_id = window->GetID("##bar");
  const bool has_bar = bar.GetWidth() >= px(24);
  ImGui::PushItemFlag(ImGuiItemFlags_NoNav, true);
  if (has_bar) note_place(parameter.label, bar.Min, bar.Max);
  if (has_bar && ImGui::ItemAdd(bar, bar_id) && !state.locked) {
    ImGui::ButtonBehavior(bar, bar_id, &hovered, &held);
    if (hovered && ImGui::IsMouseClicked(0) && (ImGui::GetIO().KeyCtrl || ImGui::IsMouseDoubleClicked(0))) {
      start_typing = true;
      held = false;
    }
    if (held) drag_by_pointer(parameter, value, bar_id, bar.GetWidth());
  }
  ImGui::PopItemFlag();

  const std::string shown = state.mixed ? "—" : shown_text(parameter, value);
  const TypedField field =
      typed_field("##number", ImVec2(row.number, middle - px(11)), ImVec2(row.number_end, middle + px(11)),
                  shown.c_str(), print_number(value), true, start_typing, state.locked);
  if (field.held) {
    drag_by_pointer(parameter, value, field.id, has_bar ? bar.GetWidth() : px(200));
    held = true;
  }
  if (!held && (g_drag.id == bar_id || g_drag.id == number_id)) g_drag.id = 0;
  if (field.entered) {
    if (const auto typed = parse_number(field.typed)) value = admit(parameter, *typed);
  }
  if (has_bar) draw_slider(parameter, value, bar, hovered, held, state.mixed);

  const bool changed = value != parameter.initial || state.mixed || state.changed;
  if (row_reset(row, changed && !state.locked, shown_text(parameter, parameter.initial).c_str())) {
    edit.reset = true;
  }

  // The menu and the tooltip belong to the whole row.
  const bool over_row =
      ImGui::IsWindowHovered() &&
      ImGui::IsMouseHoveringRect(ImVec2(row.left, row.top), ImVec2(row.number_end, row.top + row.height));
  if (over_row && !state.locked && ImGui::IsMouseReleased(1)) ImGui::OpenPopup("##menu");
  std::optional<float> pasted;
  switch (context_menu(parameter, value, changed, pasted)) {
    case MenuChoice::reset:
      edit.reset = true;
      break;
    case MenuChoice::paste:
      value = admit(parameter, *pasted);
      break;
    case MenuChoice::type:
      type_next = number_id;
      break;
    case MenuChoice::none:
      break;
  }
  if (edit.reset) value = parameter.initial;
  if (tooltip_due(window->GetID("##row"), over_row && !field.typing)) parameter_tooltip(parameter);
  edit.event = track_edit(window->GetID("##edit"), held, {&old, 1}, {&value, 1}, {&edit.before, 1});
  ImGui::PopID();
  return edit;
}

EditOf<float> parameter_row(const Parameter& parameter, float& value, const RowState& state) {
  const RowColumns row = next_row();
  row_label(row, parameter.label, state.locked);
  const EditOf<float> edit = parameter_control(parameter, value, row, state);
  end_row(row);
  return edit;
}

}  // namespace vamp::ui
