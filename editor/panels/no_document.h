#pragma once
// What stands in the picture's place when no document could be opened: why, and ways on.
#include "editor/panels/context.h"

namespace vamp::ui {

// In the middle of the current window; context.problem says why.
void draw_no_document(PanelContext& context);

}  // namespace vamp::ui
