// The command palette and the sheet of shortcuts.
#include <imgui.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include "editor/widgets/actions.h"
#include "editor/widgets/controls.h"
#include "editor/widgets/hover.h"
#include "editor/widgets/theme.h"

namespace vamp::ui {

namespace {

char lower(char c) { return static_cast<char>(std::tolower(static_cast<unsigned char>(c))); }

struct Hit {
  const Action* action;
  int score;
};

std::string title_of(const Action& action) {
  return action.menu.empty() ? action.label : action.menu + " › " + action.label;
}

}  // namespace

int Actions::match(std::string_view typed, std::string_view text) {
  int score = 1;
  size_t at = 0;
  bool joined = false;
  for (const char raw : typed) {
    const char c = lower(raw);
    if (c == ' ') {
      joined = false;
      continue;
    }
    size_t found = at;
    while (found < text.size() && lower(text[found]) != c) ++found;
    if (found == text.size()) return 0;
    const bool word = found == 0 || !std::isalnum(static_cast<unsigned char>(text[found - 1]));
    score += 1 + (joined && found == at ? 4 : 0) + (word ? 6 : 0);
    joined = true;
    at = found + 1;
  }
  return score;
}

void Actions::draw_popups() {
  if (std::exchange(palette_wanted_, false)) {
    typed_.clear();
    chosen_ = 0;
    ImGui::OpenPopup("##palette");
  }
  if (std::exchange(sheet_wanted_, false)) ImGui::OpenPopup("Keyboard shortcuts");
  draw_palette();
  draw_sheet();
  popup_was_open_ = popup_is_open();
}

void Actions::draw_palette() {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos(ImVec2(screen.x / 2, px(80)), ImGuiCond_Always, ImVec2(0.5f, 0));
  ImGui::SetNextWindowSize(ImVec2(std::min(px(560), screen.x - px(20)), 0));
  if (!ImGui::BeginPopup("##palette", ImGuiWindowFlags_NoMove)) return;
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  ImGui::SetNextItemWidth(-FLT_MIN);
  const bool entered =
      ImGui::InputTextWithHint("##typed", "Type a command", &typed_, ImGuiInputTextFlags_EnterReturnsTrue);
  if (ImGui::IsItemEdited()) chosen_ = 0;

  std::vector<Hit> hits;
  for (const Action& action : actions_) {
    const int score = match(typed_, title_of(action));
    if (score > 0) hits.push_back({&action, score});
  }
  if (!typed_.empty()) {
    std::stable_sort(hits.begin(), hits.end(), [](const Hit& a, const Hit& b) { return a.score > b.score; });
  }
  const int count = static_cast<int>(hits.size());
  if (ImGui::IsKeyPressedMap(ImGuiKey_DownArrow)) ++chosen_;
  if (ImGui::IsKeyPressedMap(ImGuiKey_UpArrow)) --chosen_;
  chosen_ = count > 0 ? std::clamp(chosen_, 0, count - 1) : 0;

  const Action* run_now = nullptr;
  ImGui::BeginChild("##hits", ImVec2(0, px(340)));
  for (int i = 0; i < count; ++i) {
    const Action& action = *hits[static_cast<size_t>(i)].action;
    const bool enabled = is_enabled(action);
    ImGui::PushID(action.id.c_str());
    ImGui::BeginDisabled(!enabled);
    if (ImGui::Selectable("##hit", i == chosen_, 0, ImVec2(0, px(22)))) run_now = &action;
    if (i == chosen_ && ImGui::IsKeyPressedMap(ImGuiKey_DownArrow)) ImGui::SetScrollHereY();
    if (i == chosen_ && ImGui::IsKeyPressedMap(ImGuiKey_UpArrow)) ImGui::SetScrollHereY();
    const ImVec2 low = ImGui::GetItemRectMin(), high = ImGui::GetItemRectMax();
    ImDrawList& list = *ImGui::GetWindowDrawList();
    const float y = std::floor((low.y + high.y - ImGui::GetFontSize()) / 2);
    list.AddText(ImVec2(low.x + px(6), y), ImGui::GetColorU32(theme().text), title_of(action).c_str());
    const ImVec2 size = ImGui::CalcTextSize(action.shortcut.c_str());
    list.AddText(ImVec2(high.x - size.x - px(8), y), ImGui::GetColorU32(theme().dim), action.shortcut.c_str());
    ImGui::EndDisabled();
    ImGui::PopID();
  }
  if (count == 0) ImGui::TextDisabled("No command fits");
  ImGui::EndChild();
  if (entered && count > 0) run_now = hits[static_cast<size_t>(chosen_)].action;
  const bool done = run_now != nullptr || ImGui::IsKeyPressedMap(ImGuiKey_Escape);
  if (done) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
  if (run_now != nullptr) run(run_now->id);
}

// Two columns: what keys do, menu by menu, and what the mouse does.
void Actions::draw_sheet() {
  const ImVec2 screen = ImGui::GetIO().DisplaySize;
  ImGui::SetNextWindowPos(ImVec2(screen.x / 2, screen.y / 2), ImGuiCond_Always, ImVec2(0.5f, 0.5f));
  ImGui::SetNextWindowSize(ImVec2(std::min(px(920), screen.x - px(40)), std::min(px(720), screen.y - px(40))));
  bool open = true;
  if (!ImGui::BeginPopupModal("Keyboard shortcuts", &open, ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove)) return;
  const float half = ImGui::GetContentRegionAvail().x / 2 - px(6);
  const auto table = [](const char* id, float keys) {
    if (!ImGui::BeginTable(id, 2, ImGuiTableFlags_RowBg)) return false;
    ImGui::TableSetupColumn("what");
    ImGui::TableSetupColumn("keys", ImGuiTableColumnFlags_WidthFixed, px(keys));
    return true;
  };
  const auto line = [](const std::string& what, const std::string& how) {
    ImGui::TableNextRow();
    ImGui::TableNextColumn();
    cell_text(what.c_str());
    ImGui::TableNextColumn();
    cell_text(how.c_str(), theme().label);
  };
  ImGui::BeginChild("keys", ImVec2(half, 0));
  section("Keys");
  if (table("##sheet", 110)) {
    for (const Action& action : actions_)
      if (!action.shortcut.empty()) line(title_of(action), action.shortcut);
    ImGui::EndTable();
  }
  ImGui::EndChild();
  ImGui::SameLine();
  ImGui::BeginChild("mouse", ImVec2(0, 0));
  section("Mouse");
  if (table("##gestures", 226)) {
    for (const auto& [what, how] : gestures_) line(what, how);
    ImGui::EndTable();
  }
  ImGui::EndChild();
  if (ImGui::IsKeyPressedMap(ImGuiKey_Escape)) ImGui::CloseCurrentPopup();
  ImGui::EndPopup();
}

}  // namespace vamp::ui
