#pragma once
// The mouse and the keys of an X display, moved as a hand does: through XTEST, so that every program there gets them
// from the server.
#include <memory>
#include <string>

namespace vamp {

class Mouse {
 public:
  enum Key : unsigned { kPageDown = 0xff56, kControl = 0xffe3, kEscape = 0xff1b };  // X's key symbols
  enum Button : int { kLeft = 1, kRight = 3, kWheelUp = 4, kWheelDown = 5 };

  // Null where there is no such display or it has no XTEST.
  static std::unique_ptr<Mouse> of_display(const std::string& display);
  ~Mouse();
  Mouse(const Mouse&) = delete;
  Mouse& operator=(const Mouse&) = delete;

  // All are sent at once; nothing is waited for.
  void move(int x, int y);
  void press(int button);
  void release(int button);
  void click(int button = kLeft);
  void key(Key key);
  void key_with_control(Key key);

  // Makes the first window that is shown that large; no window manager is asked.
  void resize_window(int width, int height);

 private:
  struct State;
  explicit Mouse(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace vamp
