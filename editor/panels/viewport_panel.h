#pragma once
// The picture: orbit, pan and zoom in it, choose parts and clusters with a click, drop presets on parts.
//   left drag in the orbit tool, middle, right or Alt+left drag: orbit     arrow keys: orbit by 5 degrees, Shift by 1
//   Shift+middle or Ctrl+Alt+left drag: pan                                wheel: zoom to the mouse
//   click: select; right click: menu of the part                           double-click on nothing: fit
//   Esc: select nothing
#include <string>

#include "editor/panels/context.h"

namespace vamp::ui {

class ViewportPanel {
 public:
  // Fills the current window.
  void draw(PanelContext& context);

 private:
  enum class Drag { none, orbit, pan, other };
  void ask_for_size(PanelContext& context, ImVec2 size);
  void draw_picture(const PanelContext& context, ImVec2 low) const;
  void update_hover(PanelContext& context, ImVec2 low, bool over);
  void handle_mouse(PanelContext& context, ImVec2 low, ImVec2 size, bool hovered);
  void handle_keys(PanelContext& context, bool hovered);
  void zoom(PanelContext& context, ImVec2 low, ImVec2 size) const;
  void click(PanelContext& context);
  void draw_menu(PanelContext& context);
  void draw_chips(const PanelContext& context, ImVec2 low, ImVec2 size, bool over) const;

  int asked_width_ = 0, asked_height_ = 0;
  Drag drag_ = Drag::none;
  int pressed_part_ = -1;        // what lay under the mouse when the button went down
  int button_ = 0;               // of the drag
  bool popup_was_open_ = false;  // in the last frame
  bool travelled_ = false;       // further than a click may
  ImVec2 hover_at_{-1, -1};
  uint64_t hover_revision_ = 0, hover_picture_ = 0;
};

// "256 samples · 18.4 s · noise 0.8 % · 72 ms a sample · llvmpipe"
std::string status_text(const RenderStatus& status);

// `Vamp · cluster 7 “grain” · 5 bases`; empty over nothing.
std::string pick_text(const Project& project, const Pick& pick);

}  // namespace vamp::ui
