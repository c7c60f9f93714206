#pragma once
// How long a window takes to answer the mouse: from the event to other pixels in the screen's framebuffer.
#include <optional>
#include <string>
#include <vector>

#include "bench/window/editor_window.h"

namespace vamp {

struct Answers {
  std::vector<double> ms;  // one of each round that was answered
  double pixels = 1;       // share of the picture that the last edit changed
  int unanswered = 0;      // rounds without a changed pixel
};

// Rounds before those that count: kernels are compiled in them.
constexpr int kWarmRounds = 3;

// The part of a picture that is watched: all but what the editor writes over its upper edge.
void watch_picture(Screen& screen, const Area& picture, std::vector<Area> except = {});

// Pulls a slider a little further in each round, to and fro, once the picture is finished and rests. `summed`: also
// waits until the selected weights are at hand.
Result<Answers> pull(EditorWindow& window, const Area& slider, int rounds, bool summed);

// Turns the view by dragging over the picture.
Result<Answers> turn(EditorWindow& window, int rounds);

}  // namespace vamp
