#pragma once
// The plain controls: section headers, rows with a list, a switch or a text, buttons, bars.
#include <span>
#include <string>

#include "editor/widgets/row.h"

namespace vamp::ui {

// A bold bar over the full width of the panel; the text is cut with an ellipsis. Returns whether the section is open;
// `open` null: it cannot be folded.
bool section(const char* title, bool* open = nullptr);

// Some air between a header and rows.
void gap(float pixels);

// label | list | reset. `initial` below 0: no default, no reset. `details` are tooltips of the list's items; it may be
// empty.
EditOf<int> combo_row(const char* label, int& choice, std::span<const char* const> names, int initial,
                      const char* description, const RowState& state = {}, std::span<const char* const> details = {});

// label | check box | reset.
EditOf<bool> toggle_row(const char* label, bool& on, bool initial, const char* description, const RowState& state = {});

// label | text; committed on Enter or when the field is left, Esc restores.
EditOf<std::string> text_row(const char* label, std::string& text, const char* description, const RowState& state = {});

// label | value, nothing to edit; the text is cut.
void info_row(const char* label, const char* value, const char* tooltip = "");

// A button of the tool bar's height; lit while `on`.
bool tool_button(const char* label, bool on, bool enabled, const char* tooltip);

// The main button of a dialog, in the accent colour.
bool primary_button(const char* label, float width);

// A horizontal bar of `fraction` (clamped to 0 .. 1) with a percentage behind it, as wide as the cell. Light on a
// selected row.
void energy_bar(float fraction, bool selected);

// A search field with a hint and a button to clear it. True when the text changed.
bool search_field(const char* id, std::string& text, const char* hint);

// Text that is cut with an ellipsis at the cell's right edge and shown in full as a tooltip where it was cut.
void cell_text(const char* text, ImU32 colour = 0);

// A selectable table row over all columns, in the style of the panels: call in the first cell. True when clicked.
bool row_selectable(const char* id, bool selected, float height = 0);

}  // namespace vamp::ui
