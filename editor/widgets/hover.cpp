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

}  // namespace vamp::ui
