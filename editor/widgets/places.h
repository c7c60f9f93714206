#pragma once
// Where the things of a frame stand in the window, by the words that people read on them: for a program that uses the
// window with a real mouse, as benchmarks do.
#include <imgui.h>

#include <string>
#include <vector>

namespace vamp::ui {

struct Place {
  std::string name;
  ImVec2 low, high;  // pixels of the window
};

// From now on places are noted; before, note_place() does nothing.
void collect_places();

// Called by what is drawn, in its own ImGui window; what is scrolled out of sight, even in part, is not noted.
void note_place(const char* name, ImVec2 low, ImVec2 high);

// What was noted since the last call.
std::vector<Place> take_places();

}  // namespace vamp::ui
