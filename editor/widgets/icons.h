#pragma once
// Small pictures drawn by strokes, crisp at every scale and independent of fonts.
#include <imgui.h>

namespace vamp::ui {

enum class Icon {
  reset,
  eye,
  eye_closed,
  lock,
  unlocked,
  solo,
  mute,
  close,
  folder,
  file,
  check,
  warning,
  chevron,
  star
};

// Into a square of `size` pixels around `centre`.
void draw_icon(ImDrawList& list, Icon icon, ImVec2 centre, float size, ImU32 colour);

// A button without a frame that shows an icon; lit in `lit_colour` when `lit`. True when pressed.
bool icon_button(const char* id, Icon icon, const char* tooltip, bool lit = false, ImU32 lit_colour = 0);

}  // namespace vamp::ui
