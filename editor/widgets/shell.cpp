#include "editor/widgets/shell.h"

#include <imgui_internal.h>

#include <algorithm>
#include <cmath>

#include "editor/widgets/hover.h"
#include "editor/widgets/notify.h"
#include "editor/widgets/theme.h"

namespace vamp::ui {

namespace {

constexpr float kToolBar = 38;
constexpr float kStatusBar = 24;

void draw_menu_bar(Actions& actions, const std::string& title) {
  if (!ImGui::BeginMenuBar()) return;
  // The menus are windows of their own; the shell around them has no padding.
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(px(8), px(6)));
  actions.draw_menus();
  ImGui::PopStyleVar();
  const float width = ImGui::CalcTextSize(title.c_str()).x + px(10);
  if (width < ImGui::GetContentRegionAvail().x) {
    ImGui::SetCursorPosX(ImGui::GetWindowWidth() - width);
    ImGui::PushStyleColor(ImGuiCol_Text, theme().dim);
    ImGui::TextUnformatted(title.c_str());
    ImGui::PopStyleColor();
  }
  ImGui::EndMenuBar();
}

void draw_tool_bar(const ShellContent& content, ImVec2 low, ImVec2 high) {
  ImDrawList& list = *ImGui::GetWindowDrawList();
  list.AddRectFilled(low, high, theme().panel);
  list.AddLine(low, ImVec2(high.x, low.y), theme().line);
  const float y = low.y + std::floor((px(kToolBar) - px(28)) / 2);
  ImGui::PushClipRect(low, high, true);
  ImGui::SetCursorScreenPos(ImVec2(low.x + px(8), y));
  float end = low.x;
  if (content.tools) {
    ImGui::BeginGroup();
    content.tools();
    ImGui::EndGroup();
    end = ImGui::GetItemRectMax().x;
  }
  if (content.tools_right) {
    // As wide as it was in the last frame; the first frame draws it out of sight.
    static float width = 10000;
    const float x = std::max(high.x - px(8) - width, end);
    ImGui::SetCursorScreenPos(ImVec2(width < 10000 ? x : high.x, y));
    ImGui::BeginGroup();
    content.tools_right();
    ImGui::EndGroup();
    const float now = ImGui::GetItemRectSize().x;
    if (now != width) request_frame(0);
    width = now;
  }
  ImGui::PopClipRect();
}

void draw_item(const StatusItem& item, ImVec2 at, float end) {
  const ImVec2 size = ImGui::CalcTextSize(item.text.c_str());
  ImGui::PushStyleColor(ImGuiCol_Text, item.colour != 0 ? item.colour : theme().label);
  ImGui::RenderTextEllipsis(ImGui::GetWindowDrawList(), at, ImVec2(end, at.y + size.y), end, end, item.text.c_str(),
                            nullptr, &size);
  ImGui::PopStyleColor();
  ImGui::SetCursorScreenPos(at);
  ImGui::Dummy(ImVec2(std::max(1.0f, std::min(size.x, end - at.x)), size.y));
  if (!item.tooltip.empty()) hover_text(item.tooltip.c_str());
}

void draw_status_bar(const ShellContent& content, ImVec2 low, ImVec2 high) {
  ImGui::GetWindowDrawList()->AddRectFilled(low, high, theme().ground);
  ImGui::PushFont(theme().small_text);
  const float y = std::floor((low.y + high.y - ImGui::GetFontSize()) / 2);
  float right = high.x - px(10);
  for (size_t i = content.status_right.size(); i-- > 0;) {
    const StatusItem& item = content.status_right[i];
    const float width = ImGui::CalcTextSize(item.text.c_str()).x;
    if (right - width < low.x) break;
    ImGui::PushID(static_cast<int>(i));
    draw_item(item, ImVec2(right - width, y), right + 2);
    ImGui::PopID();
    right -= width + px(20);
  }
  float left = low.x + px(10);
  for (const StatusItem& item : content.status_left) {
    if (left >= right) break;
    draw_item(item, ImVec2(left, y), right);
    left += ImGui::CalcTextSize(item.text.c_str()).x + px(20);
  }
  ImGui::PopFont();
}

}  // namespace

void tool_separator() {
  const ImVec2 at = ImGui::GetCursorScreenPos();
  const float x = at.x + px(5);
  ImGui::GetWindowDrawList()->AddLine(ImVec2(x, at.y + px(3)), ImVec2(x, at.y + px(25)), IM_COL32(72, 72, 72, 255));
  ImGui::Dummy(ImVec2(px(10), px(28)));
  ImGui::SameLine();
}

void draw_shell(Actions& actions, Dock& dock, const ShellContent& content) {
  actions.handle_shortcuts();
  const ImVec2 size = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos(ImVec2(0, 0));
  ImGui::SetNextWindowSize(size);
  const ImGuiWindowFlags flags = ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize |
                                 ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoSavedSettings |
                                 ImGuiWindowFlags_MenuBar | ImGuiWindowFlags_NoScrollWithMouse;
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowBorderSize, 0);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(px(8), px(5)));
  ImGui::Begin("##shell", nullptr, flags);
  ImGui::PopStyleVar();
  draw_menu_bar(actions, content.title);
  ImGui::PopStyleVar(2);
  const float menu = ImGui::GetCurrentWindow()->MenuBarHeight();
  const float tools = menu + px(kToolBar);
  const float status = size.y - px(kStatusBar);
  draw_tool_bar(content, ImVec2(0, menu), ImVec2(size.x, tools));
  dock.draw(ImVec2(0, tools), ImVec2(size.x, status));
  draw_status_bar(content, ImVec2(0, status), size);
  ImGui::End();
  actions.draw_popups();
  draw_notices(ImVec2(0, tools), ImVec2(size.x, status));
}

}  // namespace vamp::ui
