#pragma once
// The material of the selected part: its clusters, their functions and the residual.
#include "editor/panels/basis_section.h"
#include "editor/panels/basis_table.h"
#include "editor/panels/context.h"

namespace vamp::ui {

class MaterialPanel {
 public:
  void draw(PanelContext& context);

 private:
  void draw_sharing(PanelContext& context);
  void draw_cluster(PanelContext& context);
  void draw_resets(PanelContext& context);
  void draw_residual(PanelContext& context);
  void draw_buttons(PanelContext& context);

  BasisTable table_;
  BasisSection section_;
  int scope_ = 0;  // EditScope
};

}  // namespace vamp::ui
