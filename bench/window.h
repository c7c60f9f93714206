#pragma once
// What a designer feels of the window: from the mouse to changed pixels on the screen, beside Cycles' viewport in
// Blender; and what the window itself costs.
#include "bench/report.h"
#include "engine/project/project.h"

namespace vamp {

struct WindowBench {
  std::string scene_words;
  int rounds = 30;
  uint32_t samples = 64;                                       // of the picture that is edited
  bool edits = true, view = true, pace = true, cycles = true;  // which parts are measured
};

// The project has a part "Vamp" with a fitted material, and a light. Errors: failed where Xvfb is missing or the editor
// does not come up; what of the rest is missing is told in the report.
Result<Report> bench_window(Project project, const WindowBench& options);

}  // namespace vamp
