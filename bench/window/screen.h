#pragma once
// A display of one's own that nobody sees: Xvfb, whose framebuffer is a file in memory. What programs show there is
// read from it without asking the server, so that looking costs those who draw nothing.
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "bench/window/child.h"
#include "bench/window/mouse.h"
#include "engine/core/clock.h"

namespace vamp {

// Pixels of the screen.
struct Area {
  int x = 0, y = 0, width = 0, height = 0;
  friend bool operator==(const Area&, const Area&) = default;
};

class Screen {
 public:
  // Errors: failed where Xvfb (package xvfb) is missing, does not start or has another format. `folder` holds its
  // files.
  static Result<std::unique_ptr<Screen>> open(const fs::path& folder, int width, int height);
  ~Screen();
  Screen(const Screen&) = delete;
  Screen& operator=(const Screen&) = delete;

  const std::string& display() const { return display_; }  // ":93"
  Mouse& mouse() { return *mouse_; }
  int height() const { return height_; }

  // The part of the screen that is watched, and what of it is not: text that stands over a picture, the pointer.
  void watch(const Area& area, std::vector<Area> except);

  // Remembers what the area shows; changes are against it from now on.
  void remember();
  // Looks every fourth of a millisecond at every fourth row. The moment of the look at which pixels differed from what
  // is remembered, at least as many as a small patch of the picture has; nothing when the time is over.
  struct Seen {
    bool changed = false;
    Clock::time_point at;
  };
  Seen wait_for_change(double seconds);
  // Remembers again and again until nothing has changed for a while, seconds. False: it never rested.
  bool wait_for_rest(double rest, double seconds);

  // Milliseconds between two looks, of all so far: how exact the moments are.
  const std::vector<double>& looks() const { return looks_; }

 private:
  Screen() = default;
  bool differs() const;
  std::span<const uint32_t> row(int y) const;

  std::unique_ptr<Child> server_;
  std::unique_ptr<Mouse> mouse_;
  std::string display_;
  const std::byte* file_ = nullptr;  // the framebuffer's, mapped
  int height_ = 0;
  size_t file_bytes_ = 0;
  size_t pixels_at_ = 0, row_bytes_ = 0;
  Area area_;
  std::vector<Area> except_;
  std::vector<uint32_t> remembered_;
  std::vector<double> looks_;
};

}  // namespace vamp
