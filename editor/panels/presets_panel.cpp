#include "editor/panels/presets_panel.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <imgui_stdlib.h>
#include <spdlog/spdlog.h>

#include <algorithm>
#include <cstring>

#include "editor/panels/fit_figures.h"
#include "editor/widgets/controls.h"
#include "editor/widgets/theme.h"
#include "editor/widgets/thumbnails.h"

namespace vamp::ui {

namespace {

std::string note_of(const LibraryEntry& entry) {
  if (!entry.problem.empty()) return entry.problem;
  std::string note = fmt::format("{:.4g} × {:.4g} mm", entry.info.size_mm.x, entry.info.size_mm.y);
  if (!entry.info.tags.empty()) note += fmt::format("\n#{}", fmt::join(entry.info.tags, " #"));
  return note + "\nDouble-click or drag it onto a part";
}

}  // namespace

std::filesystem::path preset_of_payload(const ImGuiPayload& payload) {
  const char* text = static_cast<const char*>(payload.Data);
  const size_t size = payload.DataSize > 0 ? static_cast<size_t>(payload.DataSize) : 0;
  return std::string(text, text != nullptr ? strnlen(text, size) : 0);
}

void PresetsPanel::draw(PanelContext& context) {
  const ProjectPtr project = context.document.project();
  context.selection = valid_selection(*project, context.selection);
  search_field("search", search_, "Search presets, #tags …");
  gap(2);
  const MaterialInstance* shown = find_material(*project, context.selection.material);
  std::string query = search_;
  std::replace(query.begin(), query.end(), '#', ' ');
  const std::vector<const LibraryEntry*> found = context.presets.search(query);
  if (found.empty()) {
    ImGui::TextDisabled(context.presets.entries().empty() ? "No presets yet" : "No preset has this name or tag");
  }
  const LibraryEntry* menu = nullptr;
  ThumbnailGrid grid(72);
  for (const LibraryEntry* entry : found) {
    const std::string path = entry->info.path.string();
    const bool usable = entry->problem.empty();
    const ImTextureID picture = usable && context.thumbnail ? context.thumbnail(entry->info) : nullptr;
    const bool current = shown != nullptr && !shown->preset.empty() && shown->preset == entry->reference;
    const std::string note = note_of(*entry);
    const ThumbnailGrid::Result result = grid.item(path.c_str(), picture, entry->info.name.c_str(), current,
                                                   usable ? kPresetPayload : nullptr, path, note.c_str());
    if (result.activated && usable && context.selection.part >= 0 && context.assign_preset) {
      context.assign_preset(entry->info.path, context.selection.part);
    }
    if (result.menu) menu = entry;
  }
  grid.end();
  if (menu != nullptr) {
    renamed_ = menu->info.path;
    ImGui::OpenPopup("##menu");
  }
  if (ImGui::BeginPopup("##menu")) {
    const auto& entries = context.presets.entries();
    const auto entry = std::find_if(entries.begin(), entries.end(),
                                    [&](const LibraryEntry& other) { return other.info.path == renamed_; });
    if (entry == entries.end()) {
      ImGui::CloseCurrentPopup();
    } else {
      draw_menu(context, LibraryEntry(*entry));  // a copy: the library may be read anew
    }
    ImGui::EndPopup();
  }
  draw_rename(context);
}

void PresetsPanel::draw_menu(PanelContext& context, const LibraryEntry& entry) {
  const int part = context.selection.part;
  const bool usable = entry.problem.empty() && part >= 0 && context.assign_preset;
  const std::string onto =
      part >= 0 ? "Assign to " + context.document.project()->parts[static_cast<size_t>(part)].name : "Assign";
  if (ImGui::MenuItem(onto.c_str(), "double-click", false, usable)) context.assign_preset(entry.info.path, part);
  ImGui::Separator();
  if (ImGui::MenuItem("Duplicate", nullptr, false, entry.problem.empty())) {
    const Result<std::filesystem::path> copy = context.presets.duplicate(entry.info.path);
    if (!copy) report(context, tl::unexpected(copy.error()));
  }
  if (ImGui::MenuItem("Rename…", nullptr, false, entry.writable && entry.problem.empty())) {
    name_ = entry.info.name;
    rename_wanted_ = true;
  }
  if (ImGui::MenuItem("Delete", nullptr, false, entry.writable)) {
    const Result<std::filesystem::path> moved = context.presets.remove(entry.info.path);
    if (moved) {
      spdlog::info("moved preset {} to {}", entry.info.name, moved->string());
    } else {
      report(context, tl::unexpected(moved.error()));
    }
  }
  ImGui::Separator();
  if (ImGui::MenuItem("Read the folders again")) context.presets.rescan();
  if (ImGui::MenuItem("Copy the folder's path")) {
    ImGui::SetClipboardText(entry.info.path.parent_path().string().c_str());
  }
}

void PresetsPanel::draw_rename(PanelContext& context) {
  if (std::exchange(rename_wanted_, false)) ImGui::OpenPopup("##rename");
  if (!ImGui::BeginPopup("##rename")) return;
  ImGui::TextUnformatted("Name of the preset");
  ImGui::SetNextItemWidth(px(220));
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  const bool entered =
      ImGui::InputText("##name", &name_, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  ImGui::SameLine();
  if ((ImGui::Button("Rename") || entered) && !name_.empty()) {
    report(context, context.presets.rename(renamed_, name_));
    ImGui::CloseCurrentPopup();
  }
  ImGui::EndPopup();
}

void PresetsPanel::report(const PanelContext& context, const Status& status) const {
  if (status) return;
  spdlog::error("{}", status.error().message());
  if (context.report) context.report(status.error().message());
}

}  // namespace vamp::ui
