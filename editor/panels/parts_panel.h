#pragma once
// The parts of the model: visible or not, which material they show, and how it lies on the selected one.
#include <string>

#include "editor/panels/context.h"

namespace vamp::ui {

class PartsPanel {
 public:
  void draw(PanelContext& context);

 private:
  void draw_table(PanelContext& context);
  void draw_notes(const Scene& scene);
  void draw_part(PanelContext& context, int part);
  std::string search_;
  int shown_ = -1;    // the part that the table has scrolled to
  float height_ = 0;  // of the table
  bool resized_ = false;
  bool place_open_ = true;
};

}  // namespace vamp::ui
