#pragma once
// How an edit in a panel reaches the document: one undo step per gesture, Esc puts back what was there. Every control
// that changes the project goes through here.
#include <utility>

#include "editor/panels/context.h"
#include "editor/widgets/colour.h"
#include "editor/widgets/edit.h"
#include "editor/widgets/row.h"
#include "engine/core/check.h"

namespace vamp::ui {

// `make` returns the edit that brings the widget's present value into the project; it is called only when there is one.
template <class T, class Make>
void apply_edit(Document& document, const EditOf<T>& event, Make make) {
  switch (event.event) {
    case Edit::none:
      return;
    case Edit::began:
      document.begin_gesture();
      document.edit(make());
      return;
    case Edit::changing:
      document.edit(make());
      return;
    case Edit::committed:
      // Within a gesture the last part of it; otherwise (typed, reset, chosen from a list) a step of its own.
      document.edit(make());
      document.commit_gesture();
      return;
    case Edit::cancelled:
      document.cancel_gesture();
      return;
  }
}

// A row with a number. `make(value)` returns the edit; `make_reset()`, where given, the one that goes back to the
// default, so that a value that comes back through a unit's rounding is the default exactly.
template <class Make, class Reset>
void number_row(Document& document, const Parameter& parameter, float value, Make make, Reset make_reset,
                const RowState& state = {}) {
  DCHECK(parameter.low < parameter.high && *parameter.description != 0);
  const EditOf<float> event = parameter_row(parameter, value, state);
  apply_edit(document, event, [&] {
    return event.event == Edit::committed && (event.reset || value == parameter.initial) ? make_reset() : make(value);
  });
}

template <class Make>
void number_row(Document& document, const Parameter& parameter, float value, Make make, const RowState& state = {}) {
  number_row(
      document, parameter, value, make, [&] { return make(parameter.initial); }, state);
}

}  // namespace vamp::ui
