#include "editor/panels/presets_panel.h"

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <imgui_stdlib.h>
#include <spdlog/spdlog.h>

#include <algorithm>

#include "editor/panels/fit_figures.h"
#include "editor/panels/material_drop.h"
#include "editor/panels/preset_tags.h"
#include "editor/widgets/controls.h"
#include "editor/widgets/theme.h"
#include "editor/widgets/thumbnails.h"

namespace vamp::ui {

namespace {

std::string note_of(const LibraryEntry& entry) {
  if (!entry.problem.empty()) return entry.problem;
  std::string note = fmt::format("{:.4g} × {:.4g} mm", entry.info.size_mm.x, entry.info.size_mm.y);
  if (!entry.info.tags.empty()) note += fmt::format("\n#{}", fmt::join(entry.info.tags, " #"));
  return note + "\nDouble-click or drag it onto a part, which shows it as it was saved";
}

}  // namespace

void PresetsPanel::draw(PanelContext& context) {
  const ProjectPtr project = context.document.project();
  context.selection = valid_selection(*project, context.selection);
  search_field("search", search_, "Search presets, #tags …");
  gap(2);
  const std::vector<LibraryEntry>& entries = context.presets.entries();
  const std::vector<std::string> tags = common_tags(entries);
  if (std::find(tags.begin(), tags.end(), tag_) == tags.end()) tag_.clear();
  tag_row(tags, tag_);
  if (!tags.empty()) gap(2);
  std::string query = search_;
  std::replace(query.begin(), query.end(), '#', ' ');
  std::vector<const LibraryEntry*> own, others;
  for (const LibraryEntry* entry : context.presets.search(query))
    if (tag_.empty() || has_tag(*entry, tag_)) (entry->writable ? own : others).push_back(entry);

  const bool edited = search_.empty() && tag_.empty() && draw_edited(context);
  menu_ = nullptr;
  if (own.empty() && others.empty()) {
    ImGui::TextDisabled(entries.empty() ? "No presets yet" : "No preset has this name or tag");
  }
  const bool titles = edited || !own.empty();  // else there is nothing to tell apart
  if (!own.empty() && section("My presets", &own_open_)) draw_presets(context, own);
  if (!others.empty() && (!titles || section("Shipped", &shipped_open_))) draw_presets(context, others);

  if (menu_ != nullptr) {
    renamed_ = menu_->info.path;
    ImGui::OpenPopup("##menu");
  }
  if (ImGui::BeginPopup("##menu")) {
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

void PresetsPanel::draw_presets(PanelContext& context, const std::vector<const LibraryEntry*>& presets) {
  const ProjectPtr project = context.document.project();
  const MaterialInstance* shown = find_material(*project, context.selection.material);
  gap(2);
  ThumbnailGrid grid(72);
  for (const LibraryEntry* entry : presets) {
    const std::string path = entry->info.path.string(), note = note_of(*entry);
    const bool usable = entry->problem.empty();
    ThumbnailGrid::Item item{.id = path.c_str(), .name = entry->info.name.c_str(), .note = note.c_str()};
    item.picture = usable && context.thumbnail ? context.thumbnail(entry->info) : nullptr;
    // What was made of it is another thing, which stands above.
    item.selected = shown != nullptr && !shown->preset.empty() && shown->preset == entry->reference &&
                    shown->edits == entry->info.edits;
    item.payload_type = usable ? kPresetPayload : nullptr;
    item.payload = path;
    const ThumbnailGrid::Result result = grid.item(item);
    if (result.activated && usable && context.selection.part >= 0 && context.assign_preset) {
      context.assign_preset(entry->info.path, context.selection.part);
    }
    if (result.menu) menu_ = entry;
  }
  grid.end();
  gap(2);
}

// A preset that is dropped gives the preset; what was made of it here is found here.
bool PresetsPanel::draw_edited(PanelContext& context) {
  const ProjectPtr project = context.document.project();
  std::vector<int> edited;
  for (size_t i = 0; i < project->materials.size(); ++i)
    if (is_edited(context, project->materials[i])) edited.push_back(static_cast<int>(i));
  if (!edited.empty() && section("Edited in this project", &edited_open_)) {
    gap(2);
    bool menu = false;
    ThumbnailGrid grid(72);
    for (const int index : edited) {
      const MaterialInstance& material = project->materials[static_cast<size_t>(index)];
      std::string note = "On ";
      for (const PartState& part : project->parts)
        if (part.material == index) note += (note.size() > 3 ? ", " : "") + part.name;
      note += "\nDouble-click or drag it onto a part, which shares it";
      ThumbnailGrid::Item item{.id = material.name.c_str(), .name = material.name.c_str(), .note = note.c_str()};
      for (const LibraryEntry& entry : context.presets.entries())
        if (entry.reference == material.preset && entry.problem.empty() && context.thumbnail)
          item.picture = context.thumbnail(entry.info);
      item.selected = context.selection.material == index;
      item.changed = true;
      item.payload_type = kMaterialPayload;
      item.payload = material.name;
      const ThumbnailGrid::Result result = grid.item(item);
      if (result.activated && context.selection.part >= 0) share_with_part(context, index, context.selection.part);
      if (result.menu) {
        edited_ = material.name;
        menu = true;
      }
    }
    grid.end();
    gap(2);
    if (menu) ImGui::OpenPopup("##edited");
  }
  draw_edited_menu(context);
  return !edited.empty();
}

void PresetsPanel::draw_edited_menu(PanelContext& context) {
  if (!ImGui::BeginPopup("##edited")) return;
  const ProjectPtr project = context.document.project();
  int index = static_cast<int>(project->materials.size());
  while (--index >= 0 && project->materials[static_cast<size_t>(index)].name != edited_) {
  }
  const int part = context.selection.part;
  const std::string onto = part >= 0 ? "Share with " + project->parts[static_cast<size_t>(part)].name : "Share";
  if (index < 0) ImGui::CloseCurrentPopup();
  if (ImGui::MenuItem(onto.c_str(), "double-click", false, part >= 0 && index >= 0))
    share_with_part(context, index, part);
  if (ImGui::MenuItem("Save preset…", nullptr, false, index >= 0 && context.save_preset_as))
    context.save_preset_as(index);
  ImGui::EndPopup();
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
