#pragma once
// How the editor looks: neutral greys, so that the colour of a material can be judged, one blue accent, and amber for
// what was changed from its default.
#include <imgui.h>

namespace vamp::ui {

struct Theme {
  ImU32 ground = IM_COL32(38, 38, 38, 255);  // between panels, tab bars, status bar
  ImU32 panel = IM_COL32(47, 47, 47, 255);   // panels, tool bar, the selected tab
  ImU32 header = IM_COL32(56, 56, 56, 255);  // section headers
  ImU32 line = IM_COL32(30, 30, 30, 255);    // separators
  ImU32 field = IM_COL32(31, 31, 31, 255);   // recessed: numbers, text, slider troughs
  ImU32 field_border = IM_COL32(66, 66, 66, 255);
  ImU32 button = IM_COL32(60, 60, 60, 255);
  ImU32 button_hovered = IM_COL32(74, 74, 74, 255);
  ImU32 fill = IM_COL32(71, 112, 154, 255);  // sliders, bars
  ImU32 fill_active = IM_COL32(88, 136, 184, 255);
  ImU32 accent = IM_COL32(45, 95, 143, 255);        // selection, pressed tools
  ImU32 accent_line = IM_COL32(74, 144, 200, 255);  // the selected tab's line, focus
  ImU32 changed = IM_COL32(240, 164, 40, 255);      // differs from the default
  ImU32 error = IM_COL32(214, 84, 76, 255);
  ImU32 text = IM_COL32(222, 222, 222, 255);
  ImU32 label = IM_COL32(190, 190, 190, 255);
  ImU32 dim = IM_COL32(140, 140, 140, 255);
  ImU32 tick = IM_COL32(176, 176, 176, 255);  // the default on a slider

  float scale = 1;  // pixels per pixel of a 96 dpi screen
  ImFont* regular = nullptr;
  ImFont* bold = nullptr;
  ImFont* small_text = nullptr;
};

const Theme& theme();

// A length given for a 96 dpi screen in the pixels of this one, whole.
float px(float length);

// Loads the fonts into the current context's atlas (DejaVu Sans; another sans-serif font where that is missing; ImGui's
// own at last) and sets colours and sizes. Call at the start and again when the content scale changes, outside of a
// frame; then rebuild the font texture. `scale` is clamped to 0.5 .. 4.
void apply_theme(float scale);

// Asks for another frame within `seconds`, though nothing may happen until then: a tooltip, a fading message.
void request_frame(double seconds);

// The shortest wish since the last call, or infinity.
double take_frame_request();

}  // namespace vamp::ui
