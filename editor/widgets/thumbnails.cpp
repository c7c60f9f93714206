#include "editor/widgets/thumbnails.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "editor/widgets/hover.h"
#include "editor/widgets/theme.h"

namespace vamp::ui {

namespace {

constexpr int kLines = 3;
// Behind pictures that leave it open: as the ground on which the shipped presets are photographed.
constexpr ImU32 kGround = IM_COL32(128, 128, 128, 255);

}  // namespace

ThumbnailGrid::ThumbnailGrid(float size) : origin_(ImGui::GetCursorScreenPos()), top_(origin_.y), bottom_(origin_.y) {
  // Always as if the panel scrolled: a bar that makes the pictures smaller would remove its own cause and flicker.
  const float bar = ImGui::GetCurrentWindow()->ScrollbarY ? 0 : ImGui::GetStyle().ScrollbarSize;
  const float width = std::max(ImGui::GetContentRegionAvail().x - bar, px(24));
  spacing_ = px(6);
  columns_ = std::max(1, static_cast<int>((width + spacing_) / (px(size) + spacing_)));
  cell_ = std::floor((width + spacing_) / static_cast<float>(columns_) - spacing_);
  cell_ = std::min(cell_, px(size * 1.5f));
}

// Draws the name below the picture, centred, broken between words where it is too long for a line; returns its height.
float ThumbnailGrid::caption(const char* name, ImVec2 low, bool selected) const {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImFont& font = *ImGui::GetFont();
  const float size = ImGui::GetFontSize();
  const char* const end = name + std::strlen(name);
  float y = low.y;
  ImGui::PushStyleColor(ImGuiCol_Text, selected ? theme().text : theme().label);
  for (int line = 0; line < kLines && name < end; ++line) {
    const char* stop = end;
    if (line + 1 < kLines) {
      stop = font.CalcWordWrapPositionA(size / font.FontSize, name, end, cell_);
      if (stop == name) ++stop;
    }
    const ImVec2 room = ImGui::CalcTextSize(name, stop);
    const float x = std::max(low.x, std::floor(low.x + (cell_ - room.x) / 2));
    ImGui::RenderTextEllipsis(&list, ImVec2(x, y), ImVec2(low.x + cell_, y + size + px(2)), low.x + cell_,
                              low.x + cell_, name, stop, &room);
    y += size + px(1);
    for (name = stop; name < end && *name == ' ';) ++name;
  }
  ImGui::PopStyleColor();
  return y - low.y;
}

ThumbnailGrid::Result ThumbnailGrid::item(const Item& item) {
  Result result;
  if (column_ == columns_) {
    column_ = 0;
    top_ = bottom_;
  }
  ImGui::PushID(item.id);
  const ImVec2 low(origin_.x + static_cast<float>(column_) * (cell_ + spacing_), top_);
  const ImVec2 high(low.x + cell_, low.y + cell_);
  ++column_;
  ImGui::PushFont(theme().small_text);
  const float text = px(2) + caption(item.name, ImVec2(low.x, high.y + px(2)), item.selected);
  ImGui::PopFont();
  bottom_ = std::max(bottom_, high.y + text + spacing_);
  ImGui::SetCursorScreenPos(low);
  result.clicked = ImGui::InvisibleButton("##item", ImVec2(cell_, cell_ + text));
  const bool hovered = ImGui::IsItemHovered();
  result.activated = hovered && ImGui::IsMouseDoubleClicked(0);
  result.menu = hovered && ImGui::IsMouseReleased(1);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(low, high, ImGui::GetColorU32(kGround));
  if (item.picture != nullptr)
    list.AddImage(item.picture, low, high, ImVec2(0, 0), ImVec2(1, 1), ImGui::GetColorU32(IM_COL32_WHITE));
  if (item.changed) {
    const ImVec2 dot(high.x - px(9), low.y + px(9));
    list.AddCircleFilled(dot, px(6), ImGui::GetColorU32(theme().line));
    list.AddCircleFilled(dot, px(4.5f), ImGui::GetColorU32(theme().changed));
  }
  if (item.selected || hovered) {
    const float width = item.selected ? px(2) : px(1);
    list.AddRect(low, high, ImGui::GetColorU32(item.selected ? theme().accent_line : theme().dim), 0, 0, width);
  }
  ImGui::RenderNavHighlight(ImRect(low, high), ImGui::GetItemID());
  if (tooltip_due(ImGui::GetItemID(), hovered)) show_tooltip(item.name, item.note, "");
  if (item.payload_type != nullptr && ImGui::BeginDragDropSource()) {
    ImGui::SetDragDropPayload(item.payload_type, item.payload.c_str(), item.payload.size() + 1);
    if (item.picture != nullptr) ImGui::Image(item.picture, ImVec2(px(64), px(64)));
    ImGui::TextUnformatted(item.name);
    ImGui::EndDragDropSource();
  }
  ImGui::PopID();
  return result;
}

void ThumbnailGrid::end() {
  ImGui::SetCursorScreenPos(origin_);
  ImGui::Dummy(ImVec2(1, bottom_ - origin_.y));
}

}  // namespace vamp::ui
