#pragma once
// What was found out about the window, and how it is told.
#include <optional>
#include <string>
#include <vector>

#include "bench/report.h"
#include "bench/window/cycles_window.h"
#include "bench/window/drags.h"
#include "bench/window/pace.h"

namespace vamp {

// What of Cycles' viewport something is beside.
enum class Peer { material, light, view };

struct WindowFindings {
  struct Case {
    std::string what;
    Answers answers;
    Peer peer;
  };
  std::vector<Case> cases;
  std::optional<CyclesAnswers> cycles;
  std::string no_cycles;  // why there are none
  std::vector<Pace> paces;
  double resting = -1;        // share of a core; less than 0: not measured
  std::vector<double> looks;  // ms between two looks at the framebuffer
};

Report tell_window(const WindowFindings& found, const std::string& circumstances);

}  // namespace vamp
