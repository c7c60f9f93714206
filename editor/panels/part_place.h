#pragma once
// Where the selected part stands: moved and turned from where the model has it, as in an exploded view.
#include "editor/panels/context.h"

namespace vamp::ui {

void draw_part_place(PanelContext& context, int part);

}  // namespace vamp::ui
