#include "editor/panels/material_drop.h"

#include <algorithm>
#include <cstring>

#include "editor/model/edits_scene.h"

namespace vamp::ui {

namespace {

std::string text_of(const ImGuiPayload& payload) {
  const char* text = static_cast<const char*>(payload.Data);
  const size_t size = payload.DataSize > 0 ? static_cast<size_t>(payload.DataSize) : 0;
  return std::string(text, text != nullptr ? strnlen(text, size) : 0);
}

}  // namespace

std::filesystem::path preset_of_payload(const ImGuiPayload& payload) { return text_of(payload); }

void accept_material(PanelContext& context, int part) {
  if (part < 0 || !ImGui::BeginDragDropTarget()) return;
  if (const ImGuiPayload* preset = ImGui::AcceptDragDropPayload(kPresetPayload)) {
    if (context.assign_preset) context.assign_preset(preset_of_payload(*preset), part);
  }
  if (const ImGuiPayload* shared = ImGui::AcceptDragDropPayload(kMaterialPayload)) {
    const ProjectPtr project = context.document.project();
    const std::string name = text_of(*shared);
    for (size_t i = 0; i < project->materials.size(); ++i)
      if (project->materials[i].name == name) {
        share_with_part(context, static_cast<int>(i), part);
        break;
      }
  }
  ImGui::EndDragDropTarget();
}

void share_with_part(PanelContext& context, int material, int part) {
  context.document.edit(use_material_of(*context.document.project(), part, material));
  context.selection = select_part(*context.document.project(), part);
}

bool is_edited(const PanelContext& context, const MaterialInstance& material) {
  if (!material.preset.empty())
    for (const LibraryEntry& entry : context.presets.entries())
      if (entry.reference == material.preset) return entry.info.edits != material.edits;
  return material.edits != EditLayer{};
}

}  // namespace vamp::ui
