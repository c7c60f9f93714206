#pragma once
// The frame around the panels: menu bar, tool bar, dock, status bar, messages.
#include <functional>
#include <string>
#include <vector>

#include "editor/widgets/actions.h"
#include "editor/widgets/dock.h"

namespace vamp::ui {

struct StatusItem {
  std::string text;
  ImU32 colour = 0;  // 0: the theme's label colour
  std::string tooltip;
};

struct ShellContent {
  std::string title;                    // at the right end of the menu bar, such as "derby.vampproj*"
  std::function<void()> tools;          // draws the tool bar, from the left; items end with SameLine()
  std::function<void()> tools_right;    // drawn right-aligned
  std::vector<StatusItem> status_left;  // cut where the right ones need the room
  std::vector<StatusItem> status_right;
};

// Draws the whole window's content; between NewFrame and Render. Also handles shortcuts, palette, sheet and notices.
void draw_shell(Actions& actions, Dock& dock, const ShellContent& content);

// A thin line between groups of tools.
void tool_separator();

}  // namespace vamp::ui
