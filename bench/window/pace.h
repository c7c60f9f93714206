#pragma once
// What the window's own work costs: the renderer while it is used, and the machine while it rests.
#include <vector>

#include "bench/window/editor_window.h"

namespace vamp {

struct Pace {
  std::string what;
  double frames = 0, vertices = 0;  // frames built a second; of a frame
  std::vector<double> shares;       // of the tiles a second that the renderer made in the resting phases beside it
  double asked = 0;                 // at least; 0: nothing
};

// A window whose picture refines without end: its mouse rests, moves over the material panel so that some thirty frames
// a second are drawn, or moves without pause; in turn, several times.
Result<std::vector<Pace>> measure_paces(EditorWindow& window);

// Waits until the picture is finished and the kernels that may be wanted later are made, at most two minutes. The
// driver keeps them: that is how the window is from its second start on.
Status wait_until_idle(EditorWindow& window);

// Share of a core that the program takes over some seconds, once its picture is finished.
Result<double> processor_share(EditorWindow& window, double seconds);

}  // namespace vamp
