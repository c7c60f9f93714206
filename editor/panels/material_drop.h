#pragma once
// Presets and materials that are dragged with the mouse, and what becomes of them where they are let go.
#include <filesystem>

#include "editor/panels/context.h"

namespace vamp::ui {

// A preset as it was saved; carries its path, as text with a zero at the end.
inline constexpr const char* kPresetPayload = "vamp.preset";
std::filesystem::path preset_of_payload(const ImGuiPayload& payload);

// A material of the document with its edits, to be shared; carries its name.
inline constexpr const char* kMaterialPayload = "vamp.material";

// Makes the last item a place where either is put on a part; `part` below 0 takes none.
void accept_material(PanelContext& context, int part);

// Shares a material of the document with a part, which is selected then.
void share_with_part(PanelContext& context, int material, int part);

// Whether a material is not what its preset was saved as, or its model's own was edited.
bool is_edited(const PanelContext& context, const MaterialInstance& material);

}  // namespace vamp::ui
