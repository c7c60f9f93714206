#include "editor/panels/preset_tags.h"

#include <imgui.h>

#include <algorithm>
#include <map>

#include "editor/widgets/theme.h"

namespace vamp::ui {

namespace {

constexpr size_t kMostTags = 8;
constexpr size_t kFewPresets = 6;  // that are seen at a glance

bool chip(const char* label, bool on) {
  if (on) ImGui::PushStyleColor(ImGuiCol_Button, theme().accent);
  const bool pressed = ImGui::Button(label, ImVec2(0, px(20)));
  if (on) ImGui::PopStyleColor();
  return pressed;
}

}  // namespace

std::vector<std::string> common_tags(const std::vector<LibraryEntry>& entries) {
  if (entries.size() < kFewPresets) return {};
  std::map<std::string, size_t> counts;
  for (const LibraryEntry& entry : entries)
    for (const std::string& tag : entry.info.tags) ++counts[tag];
  std::vector<std::string> tags;
  for (const auto& [tag, count] : counts)
    if (count > 1 && count < entries.size()) tags.push_back(tag);
  std::stable_sort(tags.begin(), tags.end(),
                   [&](const std::string& a, const std::string& b) { return counts[a] > counts[b]; });
  if (tags.size() > kMostTags) tags.resize(kMostTags);
  return tags;
}

bool has_tag(const LibraryEntry& entry, std::string_view tag) {
  return std::find(entry.info.tags.begin(), entry.info.tags.end(), tag) != entry.info.tags.end();
}

void tag_row(const std::vector<std::string>& tags, std::string& chosen) {
  if (tags.empty()) return;
  const float right = ImGui::GetCursorScreenPos().x + ImGui::GetContentRegionAvail().x;
  ImGui::PushFont(theme().small_text);
  ImGui::PushStyleVar(ImGuiStyleVar_FramePadding, ImVec2(px(6), px(3)));
  ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, ImVec2(px(4), px(4)));
  if (chip("all", chosen.empty())) chosen.clear();
  for (const std::string& tag : tags) {
    const float end = ImGui::GetItemRectMax().x + px(4) + ImGui::CalcTextSize(tag.c_str()).x + px(12);
    if (end > right && tag != chosen) continue;
    ImGui::SameLine();
    if (chip(tag.c_str(), chosen == tag)) chosen = chosen == tag ? "" : tag;
  }
  ImGui::PopStyleVar(2);
  ImGui::PopFont();
}

}  // namespace vamp::ui
