#pragma once
// GLFW's callbacks to the input queue; cursors and clipboard from ImGui to GLFW.
#include <memory>
#include <string>
#include <vector>

struct GLFWwindow;
struct GLFWcursor;

namespace vamp::window {

class InputQueue;

// What happens to the window itself, collected until someone asks.
struct WindowEvents {
  bool resized = false;
  bool close_wanted = false;
  bool exposed = false;  // the system wants the content drawn again
  bool scale_changed = false;
  std::vector<std::string> dropped;
};

// Installs the callbacks; one for each window, which must outlive it. Uses the window's user pointer.
class GlfwInput {
 public:
  explicit GlfwInput(GLFWwindow* window);
  ~GlfwInput();
  GlfwInput(const GlfwInput&) = delete;
  GlfwInput& operator=(const GlfwInput&) = delete;

  InputQueue& queue() { return *queue_; }
  WindowEvents& events() { return events_; }
  bool pending() const;  // anything to react to
  void update_cursor();  // after a frame: the shape that ImGui asked for

 private:
  GLFWwindow* window_;
  std::unique_ptr<InputQueue> queue_;
  WindowEvents events_;
  std::vector<GLFWcursor*> cursors_;
  int shown_cursor_ = -2;
};

}  // namespace vamp::window
