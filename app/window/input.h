#pragma once
// Input events between the window and ImGui, in order. ImGui 1.86 sees only the state at the start of a frame, so that
// a key pressed and released between two frames would be lost; here such a release waits for the next frame.
#include <imgui.h>

#include <deque>

namespace vamp::window {

class InputQueue {
 public:
  // Positions in framebuffer pixels; keys are GLFW's numbers.
  void mouse_moved(float x, float y);
  void mouse_left_window();
  void mouse_button(int button, bool down);
  void wheel(float x, float y);
  void key(int key, bool down);
  void character(unsigned codepoint);
  void focus(bool focused);

  // Hands over as many events as one frame can tell apart. Call before ImGui::NewFrame.
  void apply(ImGuiIO& io);
  bool empty() const { return events_.empty(); }

 private:
  struct Event {
    enum class Kind { move, button, wheel, key, character, focus } kind;
    int code = 0;
    bool down = false;
    float x = 0;
    float y = 0;
  };
  std::deque<Event> events_;
};

// Sets io.KeyMap for GLFW's key numbers.
void map_keys(ImGuiIO& io);

}  // namespace vamp::window
