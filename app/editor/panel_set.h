#pragma once
// The panels and where they stand when nobody moved them.
#include <memory>

#include "editor/panels/context.h"
#include "editor/widgets/dock.h"

namespace vamp {

class PanelSet {
 public:
  PanelSet();
  ~PanelSet();
  // Both must outlive the set.
  void add_to(ui::Dock& dock, ui::PanelContext& context);

  static ui::DockLayout default_layout();

 private:
  struct Panels;
  std::unique_ptr<Panels> panels_;
};

}  // namespace vamp
