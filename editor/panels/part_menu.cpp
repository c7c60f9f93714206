#include "editor/panels/part_menu.h"

#include <algorithm>

#include "editor/model/edits_scene.h"
#include "editor/panels/fit_figures.h"
#include "editor/panels/material_drop.h"
#include "editor/panels/view_commands.h"
#include "editor/widgets/hover.h"

namespace vamp::ui {

namespace {

void presets_menu(PanelContext& context, int part) {
  if (!ImGui::BeginMenu("Assign preset", !context.presets.entries().empty())) return;
  for (const LibraryEntry& entry : context.presets.entries()) {
    ImGui::PushID(&entry);
    if (ImGui::MenuItem(entry.info.name.c_str(), nullptr, false, entry.problem.empty()) && context.assign_preset)
      context.assign_preset(entry.info.path, part);
    ImGui::PopID();
  }
  ImGui::EndMenu();
}

// The materials of the other parts, with their edits.
void materials_menu(PanelContext& context, int part) {
  const ProjectPtr project = context.document.project();
  const int own = project->parts[static_cast<size_t>(part)].material;
  if (!ImGui::BeginMenu("Share the material of", project->materials.size() > 1)) return;
  for (int i = 0; i < static_cast<int>(project->materials.size()); ++i) {
    if (i == own) continue;
    const MaterialInstance& material = project->materials[static_cast<size_t>(i)];
    std::string users;
    for (const PartState& other : project->parts)
      if (other.material == i) users += (users.empty() ? "" : ", ") + other.name;
    ImGui::PushID(i);
    if (ImGui::MenuItem(material.name.c_str(), is_edited(context, material) ? "edited" : nullptr))
      share_with_part(context, i, part);
    hover_text(("On " + users).c_str());
    ImGui::PopID();
  }
  ImGui::EndMenu();
}

}  // namespace

void part_menu(PanelContext& context, int part) {
  const ProjectPtr project = context.document.project();
  const PartState& state = project->parts[static_cast<size_t>(part)];
  ImGui::TextDisabled("%s", state.name.c_str());
  ImGui::Separator();
  presets_menu(context, part);
  materials_menu(context, part);
  if (ImGui::MenuItem("Copy material", "Ctrl+C")) copy_material(context, part);
  if (ImGui::MenuItem("Paste material", "Ctrl+V", false, can_paste_material(context)))
    paste_material_onto(context, part);
  if (ImGui::MenuItem("Use the model's own material")) context.document.edit(use_own_material(*project, part));
  const bool shared = std::count_if(project->parts.begin(), project->parts.end(),
                                    [&](const PartState& other) { return other.material == state.material; }) > 1;
  if (ImGui::MenuItem("Make unique", nullptr, false, shared))
    context.document.edit(make_material_unique(*project, part));
  hover_text("Gives the part a copy of its material, so that edits leave the others alone");
  ImGui::Separator();
  if (ImGui::MenuItem("Frame", "F")) fit_part(context, part);
  if (ImGui::MenuItem(state.visible ? "Hide" : "Show", "H"))
    context.document.edit(show_part(*project, part, !state.visible));
  if (ImGui::MenuItem("Hide others", "Shift+H")) context.document.edit(show_only(*project, part));
  if (ImGui::MenuItem("Show all", "Alt+H")) context.document.edit(show_only(*project, -1));
  ImGui::Separator();
  const auto moved = [](const PartState& each) { return each.place != Placement{}; };
  if (ImGui::MenuItem("Put back", nullptr, false, moved(state))) context.document.edit(put_back(*project, part));
  hover_text("Where the model has the part");
  if (ImGui::MenuItem("Put all parts back", nullptr, false,
                      std::any_of(project->parts.begin(), project->parts.end(), moved)))
    context.document.edit(put_back(*project, -1));
}

void copy_material(PanelContext& context, int part) {
  const ProjectPtr project = context.document.project();
  if (part < 0 || static_cast<size_t>(part) >= project->parts.size()) return;
  const MaterialInstance* material = find_material(*project, project->parts[static_cast<size_t>(part)].material);
  if (material == nullptr) return;
  context.copied_material = *material;
  context.copied_from = project->scene;
}

bool can_paste_material(const PanelContext& context) {
  if (!context.copied_material) return false;
  // A material of the model itself means nothing in another one.
  return !context.copied_material->preset.empty() || context.copied_from == context.document.project()->scene;
}

void paste_material_onto(PanelContext& context, int part) {
  if (!can_paste_material(context)) return;
  const ProjectPtr project = context.document.project();
  context.document.edit(paste_material(*project, part, *context.copied_material));
  context.selection = valid_selection(*context.document.project(), context.selection);
}

}  // namespace vamp::ui
