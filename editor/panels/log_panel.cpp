#include "editor/panels/log_panel.h"

#include <array>

#include "editor/widgets/controls.h"
#include "editor/widgets/hover.h"
#include "editor/widgets/theme.h"
#include "engine/core/log.h"
#include "engine/core/text.h"

namespace vamp::ui {

namespace {

bool contains(const std::string& text, const std::string& wanted) {
  return lower(text).find(lower(wanted)) != std::string::npos;
}

ImU32 colour_of(int level) {
  if (level >= spdlog::level::err) return theme().error;
  if (level == spdlog::level::warn) return theme().changed;
  return level == spdlog::level::info ? theme().label : theme().dim;
}

}  // namespace

void LogPanel::draw(PanelContext&) {
  constexpr std::array<int, 4> kLevels{spdlog::level::trace, spdlog::level::info, spdlog::level::warn,
                                       spdlog::level::err};
  constexpr std::array<const char*, 4> kNames{"All", "Info", "Warnings", "Errors"};
  ImGui::SetNextItemWidth(px(96));
  ImGui::Combo("##level", &least_, kNames.data(), static_cast<int>(kNames.size()));
  hover_text("Lines of this level and above");
  ImGui::SameLine();
  std::vector<LogLine> lines = recent_log();
  std::erase_if(lines, [&](const LogLine& line) {
    return line.level < kLevels[static_cast<size_t>(least_)] || (!search_.empty() && !contains(line.text, search_));
  });
  if (ImGui::Button("Copy")) {
    std::string all;
    for (const LogLine& line : lines) all += line.text + '\n';
    ImGui::SetClipboardText(all.c_str());
  }
  hover_text("Copies the lines that are shown");
  ImGui::SameLine();
  search_field("search", search_, "Search the log");
  gap(2);
  if (!ImGui::BeginChild("lines")) {
    ImGui::EndChild();
    return;
  }
  const bool at_end = ImGui::GetScrollY() >= ImGui::GetScrollMaxY();
  for (const LogLine& line : lines) {
    ImGui::PushStyleColor(ImGuiCol_Text, colour_of(line.level));
    ImGui::PushTextWrapPos(0);
    ImGui::TextUnformatted(line.text.c_str(), line.text.c_str() + line.text.size());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
  }
  if (at_end) ImGui::SetScrollHereY(1);
  ImGui::EndChild();
}

}  // namespace vamp::ui
