#pragma once
// The program's window: input to ImGui, ImGui's output to the screen, and the loop that sleeps when nothing happens.
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "engine/core/error.h"

namespace vamp::gpu {
class Device;
}

namespace vamp::window {

class Textures;

// Where the window is, for the next start. Screen coordinates.
struct Place {
  int x = 0;
  int y = 0;
  int width = 1600;
  int height = 1000;
  bool maximised = false;
  bool placed = false;  // false: the system chooses the position
};

enum class UiRenderer { automatic, cpu, vulkan };  // automatic: the CPU where the device is one

struct WindowOptions {
  std::string title = "Vamp";
  Place place;
  float scale = 0;  // 0: the screen's
  UiRenderer renderer = UiRenderer::automatic;
};

// What the loop calls. All on the thread of run().
struct Hooks {
  std::function<void()> frame;         // ImGui calls, between NewFrame and Render
  std::function<void()> shown;         // the frame has gone to the screen
  std::function<double()> wake_after;  // seconds until the next frame without any event; asked after each frame
  std::function<void(float)> rescale;  // fonts and sizes for this scale; called first of all and on changes
  std::function<void()> close_wanted;  // the user asked to close; call quit() to do so. Empty: quits
  std::function<void(std::vector<std::string>)> dropped;  // files dropped on the window
};

struct FrameTimes {
  double build_ms = 0;    // ImGui and the panels
  double draw_ms = 0;     // rasterising
  double present_ms = 0;  // acquire, submit, present
  uint64_t frames = 0;    // built so far
  uint64_t presented = 0;
};

class Window {
 public:
  // What the Vulkan instance and device need for a window. Starts the window system; error (failed) without a display.
  static Result<std::vector<std::string>> instance_extensions();
  static std::vector<std::string> device_extensions();

  // Needs a current ImGui context. The device was made with the extensions above; device and textures must outlive the
  // window.
  static Result<std::unique_ptr<Window>> open(gpu::Device& device, Textures& textures, const WindowOptions& options);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  // Runs until quit(). Sleeps while nothing happens; at most about 60 frames a second. Throws MachineError.
  void run(const Hooks& hooks);
  void quit();

  // From any thread: there is something new to show. Several calls before the next frame make one frame.
  void wake();
  // The same for what the last frame asked for and is waited for: the next frame comes at once.
  void show_soon();

  void set_title(const std::string& title);
  Place place() const;
  float scale() const;
  void set_scale(float scale);  // from the next frame on; 0: the screen's
  const FrameTimes& times() const;
  const char* renderer_name() const;  // "CPU" or "Vulkan"

 private:
  struct State;
  explicit Window(std::unique_ptr<State> state);
  bool draw_frame(const Hooks& hooks);
  bool fit(uint32_t width, uint32_t height);
  void show(bool changed);
  std::unique_ptr<State> state_;
};

}  // namespace vamp::window
