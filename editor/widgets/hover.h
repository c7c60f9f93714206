#pragma once
// Tooltips that wait a moment and do not stand in the way of a drag.
#include <imgui.h>

namespace vamp::ui {

// Whether the pointer has rested for the tooltip's delay on the thing `id`; `hovered` says whether it is on it now.
bool tooltip_due(ImGuiID id, bool hovered);

// A tooltip for the last item. Several lines are allowed; the first may be followed by details.
void hover_text(const char* text);

// A tooltip with a bold title and wrapped text; `footer` is dim. Empty strings are left out.
void show_tooltip(const char* title, const char* text, const char* footer);

// Whether a menu, a list or another popup is open now. One that Esc closes is gone before anything is drawn: who
// listens to Esc asks in the frame before.
bool popup_is_open();

}  // namespace vamp::ui
