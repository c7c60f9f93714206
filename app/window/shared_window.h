#pragma once
// An X window whose pixels the CPU writes: into memory that is shared with the server (MIT-SHM), of which only what
// changed is put. A swapchain would send the whole window through the server's socket for each frame.
#include <memory>
#include <span>

#include "app/window/cpu_rasteriser.h"

struct GLFWwindow;

namespace vamp::window {

class SharedWindow {
 public:
  // Null where the window is not X11's, its server cannot share memory with this program, or its pixels are not
  // 0xRRGGBB in 32 bits.
  static std::unique_ptr<SharedWindow> open(GLFWwindow* window);
  ~SharedWindow();
  SharedWindow(const SharedWindow&) = delete;
  SharedWindow& operator=(const SharedWindow&) = delete;

  // Memory for a window of this size, with nothing in it. False where the server does not take it.
  bool resize(int width, int height);
  // The memory, once the server has read what was put last.
  Canvas canvas();
  // Shows rectangles of it.
  void put(std::span<const PixelRect> changed);

 private:
  struct State;
  explicit SharedWindow(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace vamp::window
