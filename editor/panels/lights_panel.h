#pragma once
// The lights, the ambient light, the environment and the background.
#include "editor/panels/context.h"

namespace vamp::ui {

class LightsPanel {
 public:
  void draw(PanelContext& context);

 private:
  void draw_list(PanelContext& context);
  void draw_buttons(PanelContext& context);
  int light_ = 0;   // the selected one
  int count_ = -1;  // of lights, when they were drawn last
};

// "Rectangle".
const char* light_word(LightType type);

// A light of a type that suits the model: where a new one starts, and what its rows are reset to.
Light new_light(const Project& project, LightType type);

// The rows of one light.
void draw_light_rows(PanelContext& context, int light);

// Ambient light, occlusion, environment, background.
void draw_surroundings(PanelContext& context);

}  // namespace vamp::ui
