#pragma once
// Where the picture is taken from, and kept views. Moving the camera is no undo step; keeping a view is.
#include <string>

#include "editor/panels/context.h"

namespace vamp::ui {

class CameraPanel {
 public:
  void draw(PanelContext& context);

 private:
  void draw_camera(PanelContext& context);
  void draw_standard_views(PanelContext& context);
  void draw_views(PanelContext& context);
  void draw_view(PanelContext& context, int index);
  std::string name_;  // of the next kept view
};

}  // namespace vamp::ui
