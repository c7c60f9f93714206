#pragma once
// The steps of the document, newest last; a click goes there.
#include "editor/panels/context.h"

namespace vamp::ui {

class HistoryPanel {
 public:
  void draw(PanelContext& context);

 private:
  uint64_t revision_ = 0;  // that was scrolled to
};

}  // namespace vamp::ui
