#include "editor/widgets/row.h"

#include <imgui_internal.h>

#include <algorithm>

#include "editor/widgets/hover.h"
#include "editor/widgets/icons.h"
#include "editor/widgets/theme.h"

namespace vamp::ui {

RowColumns next_row() {
  RowColumns row{};
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float width = ImGui::GetContentRegionAvail().x;
  row.left = at.x;
  row.top = at.y;
  row.height = px(25);
  row.right = at.x + std::max(width, px(120));
  row.reset = row.right - px(20);
  row.number_end = row.reset - px(3);
  row.number = row.number_end - std::clamp(std::floor(width * 0.2f), px(80), px(84));
  row.control_end = row.number - px(6);
  row.control = row.left + std::clamp(std::floor(width * 0.30f), px(60), px(150));
  if (row.control > row.control_end) row.control = row.control_end;
  return row;
}

void end_row(const RowColumns& row) {
  ImGui::SetCursorScreenPos(ImVec2(row.left, row.top));
  const ImGuiStyle& style = ImGui::GetStyle();
  ImGui::ItemSize(ImVec2(row.right - row.left, row.height - style.ItemSpacing.y));
}

void row_label(const RowColumns& row, const char* label, bool quiet) {
  const float size = ImGui::GetFontSize();
  const ImVec2 low(row.left, row.top + (row.height - size) / 2);
  const ImVec2 high(row.control - px(6), low.y + size + 2);
  ImGui::PushStyleColor(ImGuiCol_Text, quiet ? theme().dim : theme().label);
  const char* end = ImGui::FindRenderedTextEnd(label);
  ImGui::RenderTextEllipsis(ImGui::GetWindowDrawList(), low, high, high.x, high.x, label, end, nullptr);
  ImGui::PopStyleColor();
}

bool row_reset(const RowColumns& row, bool changed, const char* default_text) {
  const ImVec2 low(row.reset, row.top + (row.height - px(20)) / 2);
  ImGui::SetCursorScreenPos(low);
  ImGui::BeginDisabled(!changed);
  const bool pressed = ImGui::InvisibleButton("##reset", ImVec2(row.right - row.reset, px(20)));
  const bool hovered = ImGui::IsItemHovered();
  ImGui::RenderNavHighlight(ImRect(ImGui::GetItemRectMin(), ImGui::GetItemRectMax()), ImGui::GetItemID());
  ImGui::EndDisabled();
  const ImU32 colour = changed ? (hovered ? theme().text : theme().changed) : IM_COL32(96, 96, 96, 255);
  draw_icon(*ImGui::GetWindowDrawList(), Icon::reset, row.centre_of_reset(), px(12), ImGui::GetColorU32(colour));
  if (changed && tooltip_due(ImGui::GetItemID(), hovered)) show_tooltip("", "Back to the default", default_text);
  return pressed;
}

namespace {

// The text field that is being typed into. ImGui has one, so we need one.
struct Typing {
  ImGuiID id = 0;
  char text[128] = {};
  std::string start;
};
Typing g_typing;

void begin_typing(ImGuiID id, const std::string& full) {
  g_typing.id = id;
  g_typing.start = full;
  ImStrncpy(g_typing.text, full.c_str(), sizeof g_typing.text);
}

// Runs ImGui's text field in place of the handle. Handing over the activation is ImGui's business (TempInputText); it
// wants to see an activation of this item in the frame in which it starts.
void run_text_field(const ImRect& box, const char* label, ImGuiID id) {
  ImGuiContext& g = *ImGui::GetCurrentContext();
  if (!ImGui::TempInputIsActive(id)) g.NavActivateInputId = id;
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding,
                      ImVec2(px(6), std::max(0.0f, (box.GetHeight() - ImGui::GetFontSize()) / 2)));
  ImGui::TempInputText(box, id, label, g_typing.text, sizeof g_typing.text, ImGuiInputTextFlags_AutoSelectAll);
  ImGui::PopStyleVar();
}

void draw_field(const ImRect& box, const char* shown, bool right_aligned, bool hovered, bool held, ImGuiID id) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const float rounding = px(2);
  list.AddRectFilled(box.Min, box.Max, ImGui::GetColorU32(theme().field), rounding);
  const ImU32 border = held ? theme().accent_line : hovered ? IM_COL32(92, 92, 92, 255) : theme().field_border;
  list.AddRect(box.Min, box.Max, ImGui::GetColorU32(border), rounding);
  ImGui::RenderNavHighlight(box, id);
  const ImVec2 size = ImGui::CalcTextSize(shown);
  const ImVec2 inner(box.Min.x + px(4), box.Min.y);
  const float x = right_aligned ? std::max(inner.x, box.Max.x - px(6) - size.x) : inner.x + px(2);
  const float y = std::floor(box.Min.y + (box.GetHeight() - size.y) / 2);
  ImGui::PushClipRect(inner, ImVec2(box.Max.x - px(2), box.Max.y), true);
  list.AddText(ImVec2(std::floor(x), y), ImGui::GetColorU32(theme().text), shown);
  ImGui::PopClipRect();
}

}  // namespace

TypedField typed_field(const char* id_text, ImVec2 low, ImVec2 high, const char* shown, const std::string& full,
                       bool right_aligned, bool start_typing, bool locked) {
  TypedField field;
  ImGuiContext& g = *ImGui::GetCurrentContext();
  ImGuiWindow* window = ImGui::GetCurrentWindow();
  if (window->SkipItems) return field;
  const ImGuiID id = window->GetID(id_text);
  field.id = id;
  const ImRect box(low, high);
  if (!ImGui::ItemAdd(box, id, nullptr, locked ? 0 : ImGuiItemFlags_Inputable) && g_typing.id != id) return field;
  const bool tabbed = (g.LastItemData.StatusFlags & ImGuiItemStatusFlags_FocusedByTabbing) != 0;

  // While typing ImGui's field stands here; whatever ended it (Enter, Tab, Esc, a click elsewhere, the loss of the
  // active item to another widget), the text then in the buffer counts. Esc has put the first text back.
  if (g_typing.id == id) {
    if (ImGui::TempInputIsActive(id)) run_text_field(box, id_text, id);
    if (ImGui::TempInputIsActive(id)) {
      field.typing = true;
      return field;
    }
    g_typing.id = 0;
    field.typed = g_typing.text;
    field.entered = field.typed != g_typing.start;
    if (!tabbed) {
      draw_field(box, field.entered ? field.typed.c_str() : shown, right_aligned, false, false, id);
      return field;
    }
  }
  bool hovered = false;
  bool held = false;
  if (!locked) ImGui::ButtonBehavior(box, id, &hovered, &held);
  const bool asked = hovered && ImGui::IsMouseClicked(0) && (g.IO.KeyCtrl || ImGui::IsMouseDoubleClicked(0));
  const bool by_key = g.NavActivateId == id || g.NavActivateInputId == id;
  if (!locked && (asked || start_typing || tabbed || by_key)) {
    begin_typing(id, full);
    run_text_field(box, id_text, id);
    field.typing = true;
    return field;
  }
  field.hovered = hovered;
  field.held = held;
  if (hovered && !locked) ImGui::SetMouseCursor(ImGuiMouseCursor_ResizeEW);
  draw_field(box, shown, right_aligned, hovered, held, id);
  return field;
}

}  // namespace vamp::ui
