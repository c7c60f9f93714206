#pragma once
// The last lines of the program's log.
#include <string>

#include "editor/panels/context.h"

namespace vamp::ui {

class LogPanel {
 public:
  void draw(PanelContext& context);

 private:
  int least_ = 1;  // index of the level below which lines are left out
  std::string search_;
};

}  // namespace vamp::ui
