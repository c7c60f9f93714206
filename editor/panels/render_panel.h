#pragma once
// What the renderer does, and how it is to do it.
#include "editor/panels/context.h"

namespace vamp::ui {

class RenderPanel {
 public:
  void draw(PanelContext& context);

 private:
  void draw_status(PanelContext& context) const;
  void draw_settings(PanelContext& context) const;
  void draw_display(PanelContext& context) const;
};

// "1.21 GiB", "48 bytes".
std::string bytes_text(uint64_t bytes);

// "1,940".
std::string count_text(uint64_t count);

}  // namespace vamp::ui
