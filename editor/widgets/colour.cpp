#include "editor/widgets/colour.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

#include "editor/widgets/hover.h"
#include "editor/widgets/theme.h"

namespace vamp::ui {

float srgb_from_linear(float x) {
  x = std::clamp(x, 0.0f, 1.0f);
  return x <= 0.0031308f ? 12.92f * x : 1.055f * std::pow(x, 1 / 2.4f) - 0.055f;
}

float linear_from_srgb(float x) {
  x = std::clamp(x, 0.0f, 1.0f);
  return x <= 0.04045f ? x / 12.92f : std::pow((x + 0.055f) / 1.055f, 2.4f);
}

namespace {

int byte_of(float linear) { return static_cast<int>(std::lround(srgb_from_linear(linear) * 255)); }

}  // namespace

std::string hex_from_linear(const vec3& c) {
  char text[8];
  ImFormatString(text, sizeof text, "#%02X%02X%02X", byte_of(c.x), byte_of(c.y), byte_of(c.z));
  return text;
}

std::optional<vec3> linear_from_hex(std::string_view text) {
  const auto space = [](char c) { return c == ' ' || c == '\t'; };
  while (!text.empty() && (space(text.front()) || text.front() == '#')) text.remove_prefix(1);
  while (!text.empty() && space(text.back())) text.remove_suffix(1);
  if (text.size() != 3 && text.size() != 6) return std::nullopt;
  vec3 out{};
  const size_t digits = text.size() / 3;
  for (size_t i = 0; i < 3; ++i) {
    int value = 0;
    for (size_t k = 0; k < 2; ++k) {
      const char c = text[i * digits + (digits == 2 ? k : 0)];
      const int digit = c >= '0' && c <= '9'   ? c - '0'
                        : c >= 'a' && c <= 'f' ? c - 'a' + 10
                        : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                               : -1;
      if (digit < 0) return std::nullopt;
      value = value * 16 + digit;
    }
    out[static_cast<int>(i)] = linear_from_srgb(static_cast<float>(value) / 255);
  }
  return out;
}

ImU32 screen_colour(const vec3& c) { return IM_COL32(byte_of(c.x), byte_of(c.y), byte_of(c.z), 255); }

namespace {

// The picker in a popup. ImGui's picker consists of many items; here a gesture is one hold of the mouse (or one stay in
// one of its text fields). Returns whether the user holds something.
bool picker_popup(const char* id, vec3& linear) {
  if (!ImGui::BeginPopup(id)) return false;
  float encoded[3] = {srgb_from_linear(linear.x), srgb_from_linear(linear.y), srgb_from_linear(linear.z)};
  const float start[3] = {encoded[0], encoded[1], encoded[2]};
  ImGui::SetNextItemWidth(px(220));
  const ImGuiColorEditFlags flags = ImGuiColorEditFlags_NoSidePreview | ImGuiColorEditFlags_NoSmallPreview |
                                    ImGuiColorEditFlags_DisplayRGB | ImGuiColorEditFlags_DisplayHSV |
                                    ImGuiColorEditFlags_NoLabel | ImGuiColorEditFlags_NoOptions;
  ImGui::ColorPicker3("##picker", encoded, flags);
  // Only components that the user moved: a round trip through sRGB must not change the others.
  for (int i = 0; i < 3; ++i) {
    if (encoded[i] != start[i]) linear[i] = linear_from_srgb(encoded[i]);
  }
  const bool held = ImGui::IsAnyItemActive();
  ImGui::EndPopup();
  return held;
}

struct Swatch {
  bool held = false;
  bool hovered = false;
};

Swatch swatch(ImVec2 low, ImVec2 high, vec3& linear, bool locked, bool mixed) {
  Swatch result;
  ImGui::SetCursorScreenPos(low);
  ImGui::BeginDisabled(locked);
  if (ImGui::InvisibleButton("##swatch", ImVec2(high.x - low.x, high.y - low.y))) ImGui::OpenPopup("##pick");
  result.hovered = ImGui::IsItemHovered();
  const ImRect box(low, high);
  ImGui::RenderNavHighlight(box, ImGui::GetItemID());
  ImGui::EndDisabled();
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 colour = mixed ? theme().field : screen_colour(linear);
  list.AddRectFilled(low, high, ImGui::GetColorU32(colour), px(2));
  list.AddRect(low, high, ImGui::GetColorU32(result.hovered ? theme().text : theme().field_border), px(2));
  result.held = picker_popup("##pick", linear);
  return result;
}

EditOf<vec3> track(const char* id, bool held, const vec3& old, vec3& value) {
  EditOf<vec3> edit;
  edit.event = track_edit(ImGui::GetID(id), held, {&old.x, 3}, {&value.x, 3}, {&edit.before.x, 3});
  return edit;
}

bool over(const RowColumns& row) {
  return ImGui::IsWindowHovered() &&
         ImGui::IsMouseHoveringRect(ImVec2(row.left, row.top), ImVec2(row.number_end, row.top + row.height));
}

}  // namespace

EditOf<vec3> colour_row(const char* label, vec3& linear, const vec3& initial, const char* description,
                        const RowState& state) {
  const vec3 old = linear;
  const RowColumns row = next_row();
  ImGui::PushID(label);
  row_label(row, label, state.locked);
  const float middle = std::floor(row.top + row.height / 2);
  const Swatch picked = swatch(ImVec2(row.control, middle - px(7)), ImVec2(row.control_end, middle + px(7)), linear,
                               state.locked, state.mixed);
  bool reset = false;
  const std::string hex = state.mixed ? "—" : hex_from_linear(linear);
  const TypedField field =
      typed_field("##hex", ImVec2(row.number, middle - px(11)), ImVec2(row.number_end, middle + px(11)), hex.c_str(),
                  hex, true, false, state.locked);
  if (field.entered) {
    if (const auto typed = linear_from_hex(field.typed)) linear = *typed;
  }
  if (row_reset(row, (linear != initial || state.mixed) && !state.locked, hex_from_linear(initial).c_str())) {
    linear = initial;
    reset = true;
  }
  if (tooltip_due(ImGui::GetID("##row"), over(row) && !field.typing)) {
    show_tooltip(label, description, ("sRGB, default " + hex_from_linear(initial)).c_str());
  }
  EditOf<vec3> edit = track("##edit", picked.held, old, linear);
  edit.reset = reset;
  ImGui::PopID();
  end_row(row);
  return edit;
}

namespace {

// The gain when a drag of its weight began: a weight of 0 has no colour of its own.
struct GainDrag {
  ImGuiID id = 0;
  vec3 before{};
};
GainDrag g_gain_drag;

float largest(const vec3& c) { return std::max({c.x, c.y, c.z}); }

vec3 relative(const vec3& gain) { return largest(gain) > 0 ? gain / largest(gain) : vec3(1); }

// What an edit of the weight does to the gain.
EditOf<vec3> apply_weight(const EditOf<float>& scaled, float weight, const vec3& old, vec3& gain, ImGuiID id) {
  EditOf<vec3> edit;
  edit.event = scaled.event;
  if (scaled.event == Edit::began) g_gain_drag = {id, old};
  const bool dragged = g_gain_drag.id == id;
  edit.before = dragged ? g_gain_drag.before : old;
  gain = scaled.event == Edit::cancelled ? edit.before : relative(edit.before) * weight;
  if (scaled.event == Edit::committed || scaled.event == Edit::cancelled) g_gain_drag.id = 0;
  return edit;
}

}  // namespace

EditOf<vec3> gain_row(const char* label, vec3& gain, float high, const char* description, const RowState& state) {
  const vec3 old = gain;
  const RowColumns row = next_row();
  ImGui::PushID(label);
  row_label(row, label, state.locked);
  const float middle = std::floor(row.top + row.height / 2);

  const vec3 old_hue = relative(gain);
  vec3 hue = old_hue;
  const ImVec2 low(row.control_end - px(22), middle - px(8));
  const Swatch picked = swatch(low, ImVec2(row.control_end, middle + px(8)), hue, state.locked, state.mixed);

  RowColumns slider = row;
  slider.control_end = low.x - px(6);
  Parameter parameter;
  parameter.label = label;
  parameter.high = high;
  parameter.initial = 1;
  parameter.format = "%.2f ×";
  parameter.description = description;
  parameter.mapping = &kSquare;
  RowState slider_state = state;
  slider_state.changed = gain != vec3(1);
  float weight = largest(gain);
  const EditOf<float> scaled = parameter_control(parameter, weight, slider, slider_state);

  EditOf<vec3> edit;
  if (scaled.reset) {
    gain = vec3(1);
    edit = {old != gain ? Edit::committed : Edit::none, old, true};
  } else if (scaled) {
    edit = apply_weight(scaled, weight, old, gain, ImGui::GetID("##weight"));
  } else {
    // Another colour of the same weight: the size of what the picker gives is dropped.
    if (hue != old_hue && largest(hue) > 0) gain = relative(hue) * largest(old);
    edit = track("##colour", picked.held, old, gain);
  }
  ImGui::PopID();
  end_row(row);
  return edit;
}

EditOf<vec3> colour_swatch(const char* id, vec3& linear, ImVec2 size) {
  const vec3 old = linear;
  ImGui::PushID(id);
  const ImVec2 low = ImGui::GetCursorScreenPos();
  const Swatch picked = swatch(low, ImVec2(low.x + size.x, low.y + size.y), linear, false, false);
  const EditOf<vec3> edit = track("##edit", picked.held, old, linear);
  ImGui::PopID();
  return edit;
}

}  // namespace vamp::ui
