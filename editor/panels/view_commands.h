#pragma once
// Moves of the camera that menus, keys and panels share. None of them is an undo step.
#include <array>

#include "editor/panels/context.h"

namespace vamp::ui {

enum class StandardView { three_quarter, left, right, front, back, top };

struct StandardViewRow {
  StandardView view;
  const char* label;
  const char* tooltip;
};
extern const std::array<StandardViewRow, 6> kStandardViews;

// Width over height of the viewport.
float view_aspect(const PanelContext& context);

// The whole model, a part, or what is selected (the model where nothing is) fits into the picture with a margin; the
// direction of view stays.
void fit_view(PanelContext& context);
void fit_part(PanelContext& context, int part);
void fit_selection(PanelContext& context);

// A freshly opened model comes with a camera that was set up for a landscape picture: where it shows the whole model
// there, it is moved so that it does so in the picture that the window has.
void fit_opened(PanelContext& context);

// Looks at the whole model from one of its sides.
void standard_view(PanelContext& context, StandardView view);

}  // namespace vamp::ui
