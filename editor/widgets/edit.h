#pragma once
// When an edit begins, goes on and ends: one undo step per gesture.
#include <imgui.h>

#include <cstdint>
#include <span>

namespace vamp::ui {

// What a widget reports for its value, which it changes in place:
//   began      the first change of a gesture (a drag, a picker); apply the value
//   changing   a further change; apply the value
//   committed  the gesture is over, or the whole edit happened at once (typed, reset, pasted); apply the value and make
//              one undo step from `before` to it
//   cancelled  Esc, or the value is back where it was: the value is `before` again; apply it, no undo step
// A gesture that changed nothing reports nothing.
enum class Edit : uint8_t { none, began, changing, committed, cancelled };

template <class T>
struct EditOf {
  Edit event = Edit::none;
  T before{};          // the value when the gesture began; set with `committed` and `cancelled`
  bool reset = false;  // the default was asked for, by button or menu
  explicit operator bool() const { return event != Edit::none; }
};

// The rule behind every widget with a gesture, for widgets of one's own. Call each frame for each widget: `active`
// while the user holds it, `old` the value at the start of this frame's call, `value` after it (restored on Esc).
// Writes the value at the start of the gesture to `before` when it ends. At most 8 numbers.
Edit track_edit(ImGuiID id, bool active, std::span<const float> old, std::span<float> value, std::span<float> before);

// Whether a gesture is open now (has begun and not ended): autosave and undo wait for its end.
bool edit_is_open();

// True once when a widget vanished in the middle of a gesture (its panel closed, another thing was selected), so that
// its end was never reported: the application commits what it has. Call once a frame, after all widgets.
bool take_abandoned_edit();

}  // namespace vamp::ui
