#include "app/editor/preset_dialog.h"

#include <fmt/ranges.h>
#include <imgui.h>
#include <imgui_stdlib.h>

#include <algorithm>

#include "app/editor/material_ball.h"
#include "editor/widgets/controls.h"
#include "editor/widgets/notify.h"
#include "editor/widgets/theme.h"
#include "engine/core/log.h"
#include "engine/core/text.h"
#include "engine/project/file_reference.h"

namespace vamp {

std::vector<std::string> split_tags(std::string_view text) {
  constexpr std::string_view kSpace = " \t#";
  std::vector<std::string> tags;
  while (!text.empty()) {
    const size_t comma = text.find(',');
    std::string_view tag = text.substr(0, comma);
    text = comma == std::string_view::npos ? std::string_view() : text.substr(comma + 1);
    const size_t first = tag.find_first_not_of(kSpace);
    if (first == std::string_view::npos) continue;
    tag = tag.substr(first, tag.find_last_not_of(kSpace) + 1 - first);
    if (std::find(tags.begin(), tags.end(), tag) == tags.end()) tags.emplace_back(tag);
  }
  return tags;
}

PresetDialog::PresetDialog(gpu::Device& device, PresetLibrary& library, JobQueue& jobs)
    : device_(device), library_(library), jobs_(jobs) {}

void PresetDialog::open(const Project& project, int material) {
  if (material < 0 || static_cast<size_t>(material) >= project.materials.size()) return;
  const MaterialInstance& instance = project.materials[static_cast<size_t>(material)];
  preset_ = {};
  preset_.fit = instance.fit;
  preset_.edits = instance.edits;
  origin_ = instance.preset;
  for (const LibraryEntry& entry : library_.entries()) {
    if (instance.preset.empty() || entry.reference != instance.preset) continue;
    preset_.tags = entry.info.tags;
    break;
  }
  name_ = material_ = instance.name;
  tags_ = fmt::format("{}", fmt::join(preset_.tags, ", "));
  open_ = true;
}

// A preset of the user's that is called so already, whatever the case.
const LibraryEntry* PresetDialog::own_of_this_name() const {
  for (const LibraryEntry& entry : library_.entries())
    if (entry.writable && entry.problem.empty() && lower(entry.info.name) == lower(name_)) return &entry;
  return nullptr;
}

void PresetDialog::draw() {
  if (!ui::begin_dialog("Save preset", open_, 420)) return;
  ImGui::TextUnformatted("Name");
  ImGui::SetNextItemWidth(-1);
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  const bool entered =
      ImGui::InputText("##name", &name_, ImGuiInputTextFlags_EnterReturnsTrue | ImGuiInputTextFlags_AutoSelectAll);
  ui::gap(4);
  ImGui::TextUnformatted("Tags, with commas between them");
  ImGui::SetNextItemWidth(-1);
  ImGui::InputText("##tags", &tags_);
  ui::gap(4);
  const LibraryEntry* const same = own_of_this_name();
  ImGui::PushStyleColor(ImGuiCol_Text, same != nullptr ? ui::theme().changed : ui::theme().dim);
  ImGui::TextWrapped("%s", same != nullptr ? "You have a preset of this name."
                                           : "Goes to your own presets; the material then bears this name.");
  ImGui::PopStyleColor();
  ui::gap(4);
  const bool named = name_.find_first_not_of(" \t") != std::string::npos;
  ImGui::BeginDisabled(!named);
  const bool go = (ui::primary_button(same != nullptr ? "Replace it" : "Save", ui::px(96)) || entered) && named;
  bool both = false;
  if (same != nullptr) {
    ImGui::SameLine();
    both = ImGui::Button("Keep both", ImVec2(ui::px(96), ui::px(28)));
  }
  ImGui::EndDisabled();
  ImGui::SameLine();
  if (ImGui::Button("Cancel", ImVec2(ui::px(84), ui::px(28)))) open_ = false;
  if (go || both) open_ = false;
  if (!open_) ImGui::CloseCurrentPopup();
  ui::end_dialog();
  if (go || both) start(same != nullptr && go ? same->info.path : std::filesystem::path());
}

// Renders its thumbnail on a worker; a preset without one is still a preset. `over`: a preset of the user's that it
// replaces; empty: a new one.
void PresetDialog::start(const std::filesystem::path& over) {
  preset_.name = name_.substr(0, 200);
  preset_.tags = split_tags(tags_);
  ++saving_;
  jobs_.start(
      "Saving preset " + preset_.name,
      [&device = device_, preset = preset_, origin = origin_](Progress& progress) mutable -> Result<Preset> {
        // Where it came from, its licence and what this version does not know go along.
        if (const auto path = path_of_reference(origin, "", ""); path && !path->empty()) {
          if (auto from = load_preset(*path)) {
            preset.provenance = std::move(from->provenance);
            preset.licence = std::move(from->licence);
            preset.unknown_json = std::move(from->unknown_json);
          }
        }
        auto picture = render_material_ball(device, preset, progress);
        if (picture) {
          preset.thumbnail_png = std::move(*picture);
        } else {
          spdlog::warn("thumbnail of {}: {}", preset.name, picture.error().message());
        }
        return std::move(preset);
      },
      [this, over, material = material_](Result<Preset> preset) {
        --saving_;
        if (preset) finish(std::move(*preset), over, material);
      });
}

void PresetDialog::finish(Preset preset, const std::filesystem::path& over, const std::string& material) {
  const Status replaced = over.empty() ? Status() : library_.overwrite(over, preset);
  if (!replaced) return ui::notify(ui::Notice::error, replaced.error().message());
  const Result<std::filesystem::path> path = over.empty() ? library_.save_new(preset) : over;
  if (!path) return ui::notify(ui::Notice::error, path.error().message());
  ui::notify(ui::Notice::done, "Preset saved: " + path->string());
  // As the next session will read it.
  auto written = load_preset(*path);
  if (!written) return ui::notify(ui::Notice::error, written.error().message());
  if (saved) saved({*path, std::move(*written), material, preset.fit});
}

}  // namespace vamp
