#pragma once
// What can be done to one part: the menu of the right mouse button in the list and in the picture, and its actions.
#include "editor/panels/context.h"

namespace vamp::ui {

// The entries; call it within a popup. The part must exist.
void part_menu(PanelContext& context, int part);

// The material as it is now is kept for pasting, onto parts of this document or of the next one.
void copy_material(PanelContext& context, int part);
bool can_paste_material(const PanelContext& context);
void paste_material_onto(PanelContext& context, int part);

}  // namespace vamp::ui
