#pragma once
// The program in a window of an X server of the test's own, driven by keys and mouse through xdotool.
#include <sys/types.h>

#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "engine/core/files.h"
#include "engine/image/image.h"

namespace vamp::editor_test {

// A server without a screen that anybody sees; ends with the test program.
class Display {
 public:
  static constexpr int kWidth = 1280, kHeight = 800;
  Display();
  ~Display();
  // ":93"; empty when Xvfb or xdotool is not installed.
  const std::string& name() const { return name_; }

 private:
  pid_t server_ = -1;
  std::string name_;
};

// What a shell command prints on stdout; `code` gets its exit code.
std::string output_of(const std::string& command, int* code = nullptr);

// Looks every 50 ms until it holds; false after `seconds`.
bool wait_until(const std::function<bool()>& holds, double seconds = 60);

// One run of `vamp edit` with folders of its own. Its working folder is `home`.
class EditorRun {
 public:
  EditorRun(const Display& display, const fs::path& home, const std::vector<std::string>& arguments,
            int width = Display::kWidth, int height = Display::kHeight);
  ~EditorRun();

  // Waits until the first whole sample is shown.
  bool shows_picture();
  std::string log() const;
  bool running();
  // Waits for the end; the exit code, or minus the signal. -1000: it still runs.
  int wait_for_end(double seconds = 60);
  void kill_hard();

  void key(const std::string& keys) const;  // "ctrl+z"
  void type(const std::string& text) const;
  void move(int x, int y) const;
  void click(int x, int y) const;
  void double_click(int x, int y) const;
  void drag(int x0, int y0, int x1, int y1) const;

  // What the screen shows, RGB in [0, 1] as encoded.
  Image screen() const;

 private:
  std::string tool(const std::string& what) const;
  std::string display_;
  fs::path log_, home_;
  pid_t process_ = -1;
  int code_ = -1000;
};

// The variables that keep a run's settings, autosaves and presets under `home`.
std::vector<std::string> environment_of(const fs::path& home, const std::string& display);

}  // namespace vamp::editor_test
