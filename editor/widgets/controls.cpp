#include "editor/widgets/controls.h"

#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "editor/widgets/hover.h"
#include "editor/widgets/icons.h"
#include "editor/widgets/places.h"
#include "editor/widgets/theme.h"

namespace vamp::ui {

bool section(const char* title, bool* open) {
  ImGuiWindow* window = ImGui::GetCurrentWindow();
  const ImRect work = window->WorkRect;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float padding = ImGui::GetStyle().WindowPadding.x;
  const ImRect bar(ImVec2(work.Min.x - padding, at.y), ImVec2(work.Max.x + padding, at.y + px(25)));
  ImDrawList& list = *ImGui::GetWindowDrawList();
  ImGui::PushClipRect(ImVec2(bar.Min.x, window->InnerClipRect.Min.y), ImVec2(bar.Max.x, window->InnerClipRect.Max.y),
                      false);
  list.AddRectFilled(bar.Min, bar.Max, theme().header);
  list.AddLine(ImVec2(bar.Min.x, bar.Min.y), ImVec2(bar.Max.x, bar.Min.y), theme().line);
  list.AddLine(ImVec2(bar.Min.x, bar.Max.y - 1), ImVec2(bar.Max.x, bar.Max.y - 1), theme().line);
  ImGui::PopClipRect();
  float x = at.x;
  if (open != nullptr) {
    const ImGuiID id = window->GetID(title);
    const ImRect hit(at, ImVec2(work.Max.x, bar.Max.y));
    bool hovered = false, held = false;
    if (ImGui::ItemAdd(hit, id) && ImGui::ButtonBehavior(hit, id, &hovered, &held)) *open = !*open;
    ImGui::RenderNavHighlight(hit, id);
    const float half = px(4);
    const ImVec2 c(x + half, bar.GetCenter().y);
    const ImU32 colour = hovered ? theme().text : theme().dim;
    if (*open) {
      list.AddTriangleFilled(ImVec2(c.x - half, c.y - half / 2), ImVec2(c.x + half, c.y - half / 2),
                             ImVec2(c.x, c.y + half), colour);
    } else {
      list.AddTriangleFilled(ImVec2(c.x - half / 2, c.y - half), ImVec2(c.x + half, c.y),
                             ImVec2(c.x - half / 2, c.y + half), colour);
    }
    x += px(14);
  }
  ImGui::PushFont(theme().bold);
  const float size = ImGui::GetFontSize();
  const ImVec2 low(x, std::floor(bar.GetCenter().y - size / 2));
  ImGui::RenderTextEllipsis(&list, low, ImVec2(work.Max.x, bar.Max.y), work.Max.x, work.Max.x, title,
                            ImGui::FindRenderedTextEnd(title), nullptr);
  ImGui::PopFont();
  ImGui::SetCursorScreenPos(at);
  ImGui::ItemSize(ImVec2(work.GetWidth(), px(25)));
  return open == nullptr || *open;
}

void gap(float pixels) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  ImGui::SetCursorScreenPos(ImVec2(at.x, at.y + px(pixels)));
}

namespace {

bool over(const RowColumns& row) {
  return ImGui::IsWindowHovered() &&
         ImGui::IsMouseHoveringRect(ImVec2(row.left, row.top), ImVec2(row.number_end, row.top + row.height));
}

void row_tooltip(const RowColumns& row, const char* label, const char* description) {
  if (tooltip_due(ImGui::GetID("##row"), over(row))) show_tooltip(label, description, "");
}

template <class T>
EditOf<T> at_once(const T& old, const T& value, bool reset) {
  return {value != old ? Edit::committed : Edit::none, old, reset};
}

}  // namespace

EditOf<int> combo_row(const char* label, int& choice, std::span<const char* const> names, int initial,
                      const char* description, const RowState& state, std::span<const char* const> details) {
  const int old = choice;
  const int count = static_cast<int>(names.size());
  const RowColumns row = next_row();
  ImGui::PushID(label);
  row_label(row, label, state.locked);
  ImGui::SetCursorScreenPos(ImVec2(row.control, row.top + std::floor((row.height - px(22)) / 2)));
  ImGui::SetNextItemWidth(row.number_end - row.control);
  const char* shown = state.mixed ? "—" : choice >= 0 && choice < count ? names[static_cast<size_t>(choice)] : "";
  ImGui::BeginDisabled(state.locked);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(px(6), std::floor((px(22) - ImGui::GetFontSize()) / 2)));
  if (ImGui::BeginCombo("##list", shown, ImGuiComboFlags_HeightLarge)) {
    for (int i = 0; i < count; ++i) {
      if (ImGui::Selectable(names[static_cast<size_t>(i)], i == choice && !state.mixed)) choice = i;
      note_place(names[static_cast<size_t>(i)], ImGui::GetItemRectMin(), ImGui::GetItemRectMax());
      if (i == choice) ImGui::SetItemDefaultFocus();
      if (static_cast<size_t>(i) < details.size()) hover_text(details[static_cast<size_t>(i)]);
    }
    ImGui::EndCombo();
  }
  ImGui::PopStyleVar();
  ImGui::EndDisabled();
  note_place(label, ImVec2(row.control, row.top), ImVec2(row.number_end, row.top + row.height));
  bool reset = false;
  if (initial >= 0 && initial < count) {
    reset = row_reset(row, (choice != initial || state.mixed) && !state.locked, names[static_cast<size_t>(initial)]);
    if (reset) choice = initial;
  }
  row_tooltip(row, label, description);
  ImGui::PopID();
  end_row(row);
  return at_once(old, choice, reset);
}

EditOf<bool> toggle_row(const char* label, bool& on, bool initial, const char* description, const RowState& state) {
  const bool old = on;
  const RowColumns row = next_row();
  ImGui::PushID(label);
  row_label(row, label, state.locked);
  const float size = px(16);
  const ImVec2 low(row.control, std::floor(row.top + (row.height - size) / 2));
  ImGui::SetCursorScreenPos(low);
  ImGui::BeginDisabled(state.locked);
  if (ImGui::InvisibleButton("##box", ImVec2(size, size))) on = !on;
  const bool hovered = ImGui::IsItemHovered();
  const ImRect box(low, ImVec2(low.x + size, low.y + size));
  ImGui::RenderNavHighlight(box, ImGui::GetItemID());
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(box.Min, box.Max, ImGui::GetColorU32(on && !state.mixed ? theme().fill : theme().field), px(2));
  list.AddRect(box.Min, box.Max, ImGui::GetColorU32(hovered ? theme().text : theme().field_border), px(2));
  if (on && !state.mixed) draw_icon(list, Icon::check, box.GetCenter(), px(12), ImGui::GetColorU32(theme().text));
  ImGui::EndDisabled();
  const bool reset = row_reset(row, (on != initial || state.mixed) && !state.locked, initial ? "on" : "off");
  if (reset) on = initial;
  row_tooltip(row, label, description);
  ImGui::PopID();
  end_row(row);
  return at_once(old, on, reset);
}

EditOf<std::string> text_row(const char* label, std::string& text, const char* description, const RowState& state) {
  const std::string old = text;
  const RowColumns row = next_row();
  ImGui::PushID(label);
  row_label(row, label, state.locked);
  const float middle = std::floor(row.top + row.height / 2);
  const TypedField field = typed_field(
      "##text", ImVec2(row.control, middle - px(11)), ImVec2(row.number_end, middle + px(11)), text.c_str(), text,
      false, ImGui::IsMouseClicked(0) && over(row) && ImGui::GetIO().MousePos.x >= row.control, state.locked);
  if (field.entered) text = field.typed;
  if (!field.typing) row_tooltip(row, label, description);
  ImGui::PopID();
  end_row(row);
  return at_once(old, text, false);
}

void info_row(const char* label, const char* value, const char* tooltip) {
  const RowColumns row = next_row();
  ImGui::PushID(label);
  row_label(row, label, false);
  const float size = ImGui::GetFontSize();
  const ImVec2 low(row.control, std::floor(row.top + (row.height - size) / 2));
  ImGui::RenderTextEllipsis(ImGui::GetWindowDrawList(), low, ImVec2(row.right, low.y + size + 2), row.right, row.right,
                            value, nullptr, nullptr);
  if (*tooltip != 0) row_tooltip(row, label, tooltip);
  ImGui::PopID();
  end_row(row);
}

bool tool_button(const char* label, bool on, bool enabled, const char* tooltip) {
  ImGui::BeginDisabled(!enabled);
  if (on) {
    ImGui::PushStyleColor(ImGuiCol_Button, theme().accent);
    ImGui::PushStyleColor(ImGuiCol_ButtonHovered, theme().fill);
  }
  ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 1);
  const bool pressed = ImGui::Button(label, ImVec2(0, px(28)));
  ImGui::PopStyleVar();
  if (on) ImGui::PopStyleColor(2);
  ImGui::EndDisabled();
  hover_text(tooltip);
  return pressed;
}

bool primary_button(const char* label, float width) {
  ImGui::PushStyleColor(ImGuiCol_Button, theme().accent);
  ImGui::PushStyleColor(ImGuiCol_ButtonHovered, theme().fill);
  const bool pressed = ImGui::Button(label, ImVec2(width, px(28)));
  ImGui::PopStyleColor(2);
  return pressed;
}

void energy_bar(float fraction, bool selected) {
  fraction = std::isfinite(fraction) ? std::clamp(fraction, 0.0f, 1.0f) : 0;
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float line = ImGui::GetTextLineHeight();
  const float text_width = ImGui::CalcTextSize("100 %").x + px(5);
  const float full = std::max(ImGui::GetContentRegionAvail().x - text_width, px(12));
  const float width = std::max(std::round(full * fraction), px(1));
  const float middle = std::floor(at.y + line / 2);
  ImGui::GetWindowDrawList()->AddRectFilled(ImVec2(at.x, middle - px(3)), ImVec2(at.x + width, middle + px(4)),
                                            ImGui::GetColorU32(selected ? IM_COL32_WHITE : theme().fill));
  ImGui::SetCursorScreenPos(ImVec2(at.x + width + px(5), at.y));
  ImGui::Text(fraction > 0 && fraction < 0.005f ? "<1 %%" : "%.0f %%", static_cast<double>(fraction * 100));
}

bool search_field(const char* id, std::string& text, const char* hint) {
  ImGui::PushID(id);
  ImGui::PushStyleVar(ImGuiStyleVar_FrameBorderSize, 1);
  ImGui::SetNextItemWidth(-FLT_MIN);
  bool changed = ImGui::InputTextWithHint("##text", hint, &text);
  ImGui::PopStyleVar();
  if (!text.empty()) {
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    const ImVec2 after = ImGui::GetCursorScreenPos();
    ImGui::SetItemAllowOverlap();
    ImGui::SetCursorScreenPos(ImVec2(high.x - px(22), std::floor((low.y + high.y) / 2 - px(9))));
    if (icon_button("##clear", Icon::close, "Clear the search")) {
      text.clear();
      changed = true;
    }
    ImGui::SetCursorScreenPos(after);
  }
  ImGui::PopID();
  return changed;
}

void cell_text(const char* text, ImU32 colour) {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  const ImVec2 size = ImGui::CalcTextSize(text);
  if (colour != 0) ImGui::PushStyleColor(ImGuiCol_Text, colour);
  ImGui::RenderTextEllipsis(ImGui::GetWindowDrawList(), at, ImVec2(at.x + width, at.y + size.y), at.x + width,
                            at.x + width, text, nullptr, &size);
  if (colour != 0) ImGui::PopStyleColor();
  ImGui::Dummy(ImVec2(std::min(size.x, width), size.y));
  if (size.x > width) hover_text(text);
}

bool row_selectable(const char* id, bool selected, float height) {
  ImGui::PushStyleColor(ImGuiCol_HeaderHovered, selected ? theme().accent : IM_COL32(62, 62, 62, 255));
  const bool clicked = ImGui::Selectable(
      id, selected, ImGuiSelectableFlags_SpanAllColumns | ImGuiSelectableFlags_AllowItemOverlap, ImVec2(0, height));
  ImGui::PopStyleColor();
  ImGui::SameLine(0, 0);
  return clicked;
}

}  // namespace vamp::ui
