#include "editor/widgets/thumbnails.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

#include "editor/widgets/hover.h"
#include "editor/widgets/theme.h"

namespace vamp::ui {

ThumbnailGrid::ThumbnailGrid(float size) : origin_(ImGui::GetCursorScreenPos()) {
  // Always as if the panel scrolled: a bar that makes the pictures smaller would remove its own cause and flicker.
  const float bar = ImGui::GetCurrentWindow()->ScrollbarY ? 0 : ImGui::GetStyle().ScrollbarSize;
  const float width = std::max(ImGui::GetContentRegionAvail().x - bar, px(24));
  spacing_ = px(6);
  columns_ = std::max(1, static_cast<int>((width + spacing_) / (px(size) + spacing_)));
  cell_ = std::floor((width + spacing_) / static_cast<float>(columns_) - spacing_);
  cell_ = std::min(cell_, px(size * 1.5f));
}

ThumbnailGrid::Result ThumbnailGrid::item(const char* id, ImTextureID picture, const char* name, bool selected,
                                          const char* payload_type, const std::string& payload, const char* note) {
  Result result;
  ImGui::PushID(id);
  ImGui::PushFont(theme().small_text);
  const float caption = ImGui::GetFontSize() + px(4);
  const auto column = static_cast<float>(index_ % columns_), line = static_cast<float>(index_ / columns_);
  const ImVec2 low(origin_.x + column * (cell_ + spacing_), origin_.y + line * (cell_ + caption + spacing_));
  const ImVec2 high(low.x + cell_, low.y + cell_);
  ++index_;
  ImGui::SetCursorScreenPos(low);
  result.clicked = ImGui::InvisibleButton("##item", ImVec2(cell_, cell_ + caption));
  const bool hovered = ImGui::IsItemHovered();
  result.activated = hovered && ImGui::IsMouseDoubleClicked(0);
  result.menu = hovered && ImGui::IsMouseReleased(1);
  ImDrawList& list = *ImGui::GetWindowDrawList();
  if (picture != nullptr) {
    list.AddImage(picture, low, high, ImVec2(0, 0), ImVec2(1, 1), ImGui::GetColorU32(IM_COL32_WHITE));
  } else {
    list.AddRectFilled(low, high, ImGui::GetColorU32(theme().field));
  }
  if (selected || hovered) {
    const float width = selected ? px(2) : px(1);
    list.AddRect(low, high, ImGui::GetColorU32(selected ? theme().accent_line : theme().dim), 0, 0, width);
  }
  ImGui::RenderNavHighlight(ImRect(low, high), ImGui::GetItemID());

  // The name, centred where it fits.
  const ImVec2 size = ImGui::CalcTextSize(name);
  const float x = std::max(low.x, std::floor((low.x + high.x - size.x) / 2));
  ImGui::PushStyleColor(ImGuiCol_Text, selected ? theme().text : theme().label);
  ImGui::RenderTextEllipsis(&list, ImVec2(x, high.y + px(2)), ImVec2(high.x, high.y + caption), high.x, high.x, name,
                            nullptr, &size);
  ImGui::PopStyleColor();
  ImGui::PopFont();
  if (tooltip_due(ImGui::GetItemID(), hovered)) show_tooltip(name, note, "");
  if (payload_type != nullptr && ImGui::BeginDragDropSource()) {
    ImGui::SetDragDropPayload(payload_type, payload.c_str(), payload.size() + 1);
    if (picture != nullptr) ImGui::Image(picture, ImVec2(px(64), px(64)));
    ImGui::TextUnformatted(name);
    ImGui::EndDragDropSource();
  }
  ImGui::PopID();
  return result;
}

void ThumbnailGrid::end() {
  const int lines = (index_ + columns_ - 1) / columns_;
  const float caption = theme().small_text->FontSize + px(4);
  ImGui::SetCursorScreenPos(origin_);
  ImGui::Dummy(ImVec2(1, static_cast<float>(lines) * (cell_ + caption + spacing_)));
}

}  // namespace vamp::ui
