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
  name_ = instance.name;
  tags_ = fmt::format("{}", fmt::join(preset_.tags, ", "));
  open_ = true;
}

void PresetDialog::draw() {
  if (!ui::begin_dialog("Save preset", open_, 420)) return;
  ImGui::TextUnformatted("Name");
  ImGui::SetNextItemWidth(-1);
  if (ImGui::IsWindowAppearing()) ImGui::SetKeyboardFocusHere();
  const bool entered = ImGui::InputText("##name", &name_, ImGuiInputTextFlags_EnterReturnsTrue);
  ui::gap(4);
  ImGui::TextUnformatted("Tags, with commas between them");
  ImGui::SetNextItemWidth(-1);
  ImGui::InputText("##tags", &tags_);
  ui::gap(8);
  const std::string_view name(name_);
  const bool named = name.find_first_not_of(" \t") != std::string_view::npos;
  ImGui::BeginDisabled(!named);
  const bool go = (ui::primary_button("Save", ui::px(96)) || entered) && named;
  ImGui::EndDisabled();
  ImGui::SameLine();
  if (ImGui::Button("Cancel", ImVec2(ui::px(84), ui::px(28)))) open_ = false;
  if (go) open_ = false;
  if (!open_) ImGui::CloseCurrentPopup();
  ui::end_dialog();
  if (go) start();
}

// Renders its thumbnail on a worker; a preset without one is still a preset.
void PresetDialog::start() {
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
      [this](Result<Preset> preset) {
        --saving_;
        if (!preset) return;
        const auto path = library_.save_new(*preset);
        if (!path) return ui::notify(ui::Notice::error, path.error().message());
        ui::notify(ui::Notice::done, "Preset saved: " + path->string());
        if (saved) saved();
      });
}

}  // namespace vamp
