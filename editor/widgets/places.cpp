#include "editor/widgets/places.h"

#include <imgui_internal.h>

#include <utility>

namespace vamp::ui {

namespace {
bool g_collecting = false;
std::vector<Place> g_places;
}  // namespace

void collect_places() { g_collecting = true; }

void note_place(const char* name, ImVec2 low, ImVec2 high) {
  if (g_collecting && ImGui::GetCurrentWindow()->ClipRect.Contains(ImRect(low, high)))
    g_places.push_back({name, low, high});
}

std::vector<Place> take_places() { return std::exchange(g_places, {}); }

}  // namespace vamp::ui
