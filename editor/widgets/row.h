#pragma once
// The rows of a property panel: label | control | number | reset. All rows of a panel line up.
#include <imgui.h>

#include <string>

#include "editor/widgets/edit.h"
#include "editor/widgets/number.h"

namespace vamp::ui {

// Where the columns of a row stand, in screen pixels.
struct RowColumns {
  float left, control, control_end, number, number_end, reset, right;
  float top, height;
  ImVec2 centre_of_reset() const { return ImVec2((reset + right) / 2, top + height / 2); }
};

// The columns of the next row, over the width that is left in the window. Narrow panels give up the label's width
// first.
RowColumns next_row();

// Takes the row's place in the layout; call after drawing it.
void end_row(const RowColumns& row);

// The label, cut with an ellipsis where it is too long; dim when `quiet`.
void row_label(const RowColumns& row, const char* label, bool quiet = false);

// The reset button of a row: dim and inert unless `changed`, amber where it is. True when pressed.
bool row_reset(const RowColumns& row, bool changed, const char* default_text);

struct RowState {
  bool mixed = false;    // several things are selected and they differ: shows a dash
  bool locked = false;   // shown, but cannot be edited
  bool changed = false;  // offers the reset though the number itself is at its default
};

// A number with its slider. Drag the slider or the number (relative: a click alone changes nothing), Shift for a tenth
// of the speed; double-click, Ctrl+click, Tab or Enter to type; right-click for reset, copy and paste. The value is
// kept in its range and finite.
EditOf<float> parameter_row(const Parameter& parameter, float& value, const RowState& state = {});

// The same without a label and with the slider between `left` and `right`, for composed rows. `columns` says the rest.
EditOf<float> parameter_control(const Parameter& parameter, float& value, const RowColumns& columns,
                                const RowState& state = {});

// A text field in a fixed place that is a drag handle until it is asked for text. `shown` is what it shows, `full` what
// typing starts from. Returns true once, with `typed` set, when a changed text was entered; Esc leaves the old one.
struct TypedField {
  bool entered = false;
  bool held = false;  // pressed and perhaps dragged, not typing
  bool hovered = false;
  bool typing = false;
  std::string typed;
  ImGuiID id = 0;
};
TypedField typed_field(const char* id, ImVec2 low, ImVec2 high, const char* shown, const std::string& full,
                       bool right_aligned, bool start_typing, bool locked);

}  // namespace vamp::ui
