#include "editor/widgets/edit.h"

#include <imgui_internal.h>

#include <algorithm>
#include <array>
#include <utility>

#include "engine/core/check.h"

namespace vamp::ui {

namespace {

struct Gesture {
  ImGuiID id = 0;
  bool began = false;
  int frame = 0;  // the last frame in which its widget was seen
  std::array<float, 8> before{};
};

// ImGui has one active widget at a time, so there is one gesture at a time.
Gesture g_gesture;
bool g_abandoned = false;

void drop_gesture() {
  if (g_gesture.began) g_abandoned = true;
  g_gesture = {};
}

}  // namespace

Edit track_edit(ImGuiID id, bool active, std::span<const float> old, std::span<float> value, std::span<float> before) {
  CHECK(old.size() == value.size() && before.size() == value.size() && value.size() <= 8);
  const bool changed = !std::equal(value.begin(), value.end(), old.begin());

  if (g_gesture.id != id) {
    if (!active) {
      // Changed without being held: the whole edit at once.
      std::copy(old.begin(), old.end(), before.begin());
      return changed ? Edit::committed : Edit::none;
    }
    drop_gesture();
    g_gesture.id = id;
    std::copy(old.begin(), old.end(), g_gesture.before.begin());
  }
  g_gesture.frame = ImGui::GetFrameCount();
  const std::span<const float> start(g_gesture.before.data(), value.size());
  std::copy(start.begin(), start.end(), before.begin());

  // ImGui itself lets go of the widget on Esc before we see it, so `active` may be false already.
  if (ImGui::IsKeyPressedMap(ImGuiKey_Escape, false)) {
    const bool began = g_gesture.began;
    std::copy(start.begin(), start.end(), value.begin());
    g_gesture = {};
    if (active) ImGui::ClearActiveID();
    return began ? Edit::cancelled : Edit::none;
  }
  if (active) {
    if (!changed) return Edit::none;
    const Edit event = g_gesture.began ? Edit::changing : Edit::began;
    g_gesture.began = true;
    return event;
  }
  // Released. A change in this very frame counts.
  const bool began = g_gesture.began || changed;
  const bool back = std::equal(value.begin(), value.end(), start.begin());
  g_gesture = {};
  if (!began) return Edit::none;
  return back ? Edit::cancelled : Edit::committed;
}

bool edit_is_open() { return g_gesture.began; }

bool take_abandoned_edit() {
  if (g_gesture.id != 0 && g_gesture.frame != ImGui::GetFrameCount()) drop_gesture();
  return std::exchange(g_abandoned, false);
}

}  // namespace vamp::ui
