#pragma once
// What the editor tells a program that uses its window: one line of JSON on stdout for each frame.
#include "editor/panels/context.h"

namespace vamp {

class Teller {
 public:
  Teller();

  // {"frames": built so far, "vertices": of the last one, "window": [width, height], "pictures": shown so far,
  //  tile by tile, "samples", "finished", "restarted", "recombined": pixels, by the
  //  last edit, "weights_ready",
  //  "part", "cluster", "basis": what is selected, -1 for none, "places": {"Roughness": [x0, y0, x1, y1], ...}}
  // with places as their first words in the window, in its pixels; nothing that is out of sight.
  void tell(const ui::PanelContext& context) const;
};

}  // namespace vamp
