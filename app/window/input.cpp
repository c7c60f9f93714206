#include "app/window/input.h"

#include <GLFW/glfw3.h>

#include <bitset>
#include <cfloat>

namespace vamp::window {

void InputQueue::mouse_moved(float x, float y) {
  // Only the last of several moves in a row matters.
  if (!events_.empty() && events_.back().kind == Event::Kind::move) {
    events_.back().x = x;
    events_.back().y = y;
    return;
  }
  events_.push_back({Event::Kind::move, 0, false, x, y});
}

void InputQueue::mouse_left_window() { mouse_moved(-FLT_MAX, -FLT_MAX); }
void InputQueue::mouse_button(int button, bool down) {
  if (button >= 0 && button < 5) events_.push_back({Event::Kind::button, button, down});
}
void InputQueue::wheel(float x, float y) { events_.push_back({Event::Kind::wheel, 0, false, x, y}); }
void InputQueue::key(int key, bool down) {
  if (key >= 0 && key < IM_ARRAYSIZE(ImGuiIO::KeysDown)) events_.push_back({Event::Kind::key, key, down});
}
void InputQueue::character(unsigned codepoint) {
  events_.push_back({Event::Kind::character, static_cast<int>(codepoint)});
}
void InputQueue::focus(bool focused) { events_.push_back({Event::Kind::focus, 0, focused}); }

void InputQueue::apply(ImGuiIO& io) {
  std::bitset<5> buttons;  // that changed in this frame
  std::bitset<512> keys;
  bool moved = false, rolled = false, pressed = false;
  for (; !events_.empty(); events_.pop_front()) {
    const Event& e = events_.front();
    const auto code = static_cast<size_t>(e.code);
    // What would blur with an earlier event of this frame waits, and all after it.
    if (e.kind == Event::Kind::move && (buttons.any() || rolled)) return;
    if (e.kind == Event::Kind::button && (buttons[code] || rolled)) return;
    if (e.kind == Event::Kind::wheel && buttons.any()) return;
    if (e.kind == Event::Kind::key && keys[code]) return;
    // Ctrl let go right after the key or click that it belongs to.
    const bool modifier = e.code >= GLFW_KEY_LEFT_SHIFT && e.code <= GLFW_KEY_RIGHT_SUPER;
    if (e.kind == Event::Kind::key && modifier && (pressed || buttons.any())) return;
    switch (e.kind) {
      case Event::Kind::move:
        io.MousePos = ImVec2(e.x, e.y);
        moved = true;
        break;
      case Event::Kind::button:
        // A press right after a move: the widget below must first see the pointer.
        if (moved && e.down) return;
        io.MouseDown[code] = e.down;
        buttons.set(code);
        break;
      case Event::Kind::wheel:
        io.MouseWheelH += e.x;
        io.MouseWheel += e.y;
        rolled = true;
        break;
      case Event::Kind::key:
        io.KeysDown[code] = e.down;
        keys.set(code);
        pressed = pressed || (e.down && !modifier);
        io.KeyCtrl = io.KeysDown[GLFW_KEY_LEFT_CONTROL] || io.KeysDown[GLFW_KEY_RIGHT_CONTROL];
        io.KeyShift = io.KeysDown[GLFW_KEY_LEFT_SHIFT] || io.KeysDown[GLFW_KEY_RIGHT_SHIFT];
        io.KeyAlt = io.KeysDown[GLFW_KEY_LEFT_ALT] || io.KeysDown[GLFW_KEY_RIGHT_ALT];
        io.KeySuper = io.KeysDown[GLFW_KEY_LEFT_SUPER] || io.KeysDown[GLFW_KEY_RIGHT_SUPER];
        break;
      case Event::Kind::character:
        io.AddInputCharacter(static_cast<unsigned>(e.code));
        break;
      case Event::Kind::focus:
        io.AddFocusEvent(e.down);
        break;
    }
  }
}

void map_keys(ImGuiIO& io) {
  io.KeyMap[ImGuiKey_Tab] = GLFW_KEY_TAB;
  io.KeyMap[ImGuiKey_LeftArrow] = GLFW_KEY_LEFT;
  io.KeyMap[ImGuiKey_RightArrow] = GLFW_KEY_RIGHT;
  io.KeyMap[ImGuiKey_UpArrow] = GLFW_KEY_UP;
  io.KeyMap[ImGuiKey_DownArrow] = GLFW_KEY_DOWN;
  io.KeyMap[ImGuiKey_PageUp] = GLFW_KEY_PAGE_UP;
  io.KeyMap[ImGuiKey_PageDown] = GLFW_KEY_PAGE_DOWN;
  io.KeyMap[ImGuiKey_Home] = GLFW_KEY_HOME;
  io.KeyMap[ImGuiKey_End] = GLFW_KEY_END;
  io.KeyMap[ImGuiKey_Insert] = GLFW_KEY_INSERT;
  io.KeyMap[ImGuiKey_Delete] = GLFW_KEY_DELETE;
  io.KeyMap[ImGuiKey_Backspace] = GLFW_KEY_BACKSPACE;
  io.KeyMap[ImGuiKey_Space] = GLFW_KEY_SPACE;
  io.KeyMap[ImGuiKey_Enter] = GLFW_KEY_ENTER;
  io.KeyMap[ImGuiKey_Escape] = GLFW_KEY_ESCAPE;
  io.KeyMap[ImGuiKey_KeyPadEnter] = GLFW_KEY_KP_ENTER;
  io.KeyMap[ImGuiKey_A] = GLFW_KEY_A;
  io.KeyMap[ImGuiKey_C] = GLFW_KEY_C;
  io.KeyMap[ImGuiKey_V] = GLFW_KEY_V;
  io.KeyMap[ImGuiKey_X] = GLFW_KEY_X;
  io.KeyMap[ImGuiKey_Y] = GLFW_KEY_Y;
  io.KeyMap[ImGuiKey_Z] = GLFW_KEY_Z;
}

}  // namespace vamp::window
