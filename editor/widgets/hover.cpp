#include "editor/widgets/hover.h"

#include <imgui_internal.h>

#include "editor/widgets/theme.h"

namespace vamp::ui {

namespace {
constexpr double kDelay = 0.55;  // seconds
ImGuiID g_hovered = 0;
double g_since = 0;
int g_frame = 0;
}  // namespace

bool tooltip_due(ImGuiID id, bool hovered) {
  if (!hovered || ImGui::IsAnyItemActive() || ImGui::IsMouseDown(0)) {
    if (g_hovered == id) g_hovered = 0;
    return false;
  }
  const int frame = ImGui::GetFrameCount();
  if (g_hovered != id || frame > g_frame + 1) {
    g_hovered = id;
    g_since = ImGui::GetTime();
  }
  g_frame = frame;
  const double left = g_since + kDelay - ImGui::GetTime();
  if (left > 0) request_frame(left);
  return left <= 0;
}

void hover_text(const char* text) {
  if (text == nullptr || *text == 0) return;
  const ImVec2 at = ImGui::GetItemRectMin();
  ImGuiID id = ImGui::GetItemID();
  if (id == 0) id = ImHashData(&at, sizeof at);
  if (tooltip_due(id, ImGui::IsItemHovered(ImGuiHoveredFlags_AllowWhenDisabled))) show_tooltip("", text, "");
}

void show_tooltip(const char* title, const char* text, const char* footer) {
  // Below the pointer, so that it does not cover the control that it explains; above where there is no room below.
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const bool low = mouse.y > ImGui::GetIO().DisplaySize.y - px(140);
  const float right = ImGui::GetIO().DisplaySize.x - px(8);
  const bool far_right = mouse.x > right - px(320);
  ImGui::SetNextWindowPos(ImVec2(far_right ? right : mouse.x + px(8), low ? mouse.y - px(14) : mouse.y + px(22)),
                          ImGuiCond_Always, ImVec2(far_right ? 1.0f : 0.0f, low ? 1.0f : 0.0f));
  ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(px(8), px(6)));
  ImGui::BeginTooltip();
  ImGui::PushTextWrapPos(px(320));
  if (*title != 0) {
    ImGui::PushFont(theme().bold);
    ImGui::TextUnformatted(title);
    ImGui::PopFont();
  }
  if (*text != 0) ImGui::TextUnformatted(text);
  if (*footer != 0) {
    ImGui::PushStyleColor(ImGuiCol_Text, theme().dim);
    ImGui::TextUnformatted(footer);
    ImGui::PopStyleColor();
  }
  ImGui::PopTextWrapPos();
  ImGui::EndTooltip();
  ImGui::PopStyleVar();
}

bool popup_is_open() { return ImGui::IsPopupOpen("", ImGuiPopupFlags_AnyPopupId | ImGuiPopupFlags_AnyPopupLevel); }

}  // namespace vamp::ui
