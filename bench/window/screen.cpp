#include "bench/window/screen.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <thread>

namespace vamp {
namespace {

constexpr int kRowStep = 4;                             // every fourth row is looked at
constexpr int kPatch = 12;                              // pixels in those rows that must differ: no stray dot
constexpr auto kLook = std::chrono::microseconds(250);  // between two looks

// The words of an X window dump's head (XWDFile.h), each four bytes, the most significant first.
enum XwdWord : size_t { kHeadBytes = 0, kBitsPerPixel = 11, kBytesPerLine = 12, kColours = 19 };
constexpr size_t kColourBytes = 12;

size_t xwd_word(const std::byte* file, XwdWord word) {
  size_t value = 0;
  for (size_t i = 0; i < 4; ++i) value = value << 8 | std::to_integer<size_t>(file[4 * word + i]);
  return value;
}

tl::unexpected<Error> no_screen(std::string_view found) {
  return fail(ErrorKind::failed, "Xvfb", "", "a display of its own (package xvfb)", found);
}

}  // namespace

Result<std::unique_ptr<Screen>> Screen::open(const fs::path& folder, int width, int height) {
  std::unique_ptr<Screen> screen(new Screen);
  screen->height_ = height;
  // It prints the number of the display once it is ready for programs.
  VAMP_TRY(screen->server_,
           Child::start({"Xvfb", "-displayfd", "1", "-screen", "0", fmt::format("{}x{}x24", width, height), "-fbdir",
                         folder.string(), "-nolisten", "tcp"},
                        {}, folder / "xvfb.log"));
  const std::string number = screen->server_->line_after(0, 20).text;
  if (number.empty()) return no_screen("it does not start");
  screen->display_ = ":" + number;
  screen->mouse_ = Mouse::of_display(screen->display_);
  if (!screen->mouse_) return no_screen("no XTEST, which moves the mouse");

  const int file = ::open((folder / "Xvfb_screen0").c_str(), O_RDONLY | O_CLOEXEC);
  struct stat about {};
  if (file < 0 || fstat(file, &about) != 0) return no_screen("no framebuffer in " + folder.string());
  screen->file_bytes_ = static_cast<size_t>(about.st_size);
  void* const mapped = mmap(nullptr, screen->file_bytes_, PROT_READ, MAP_SHARED, file, 0);
  close(file);
  if (mapped == MAP_FAILED) return no_screen("a framebuffer that cannot be mapped");
  screen->file_ = static_cast<const std::byte*>(mapped);
  screen->pixels_at_ = xwd_word(screen->file_, kHeadBytes) + kColourBytes * xwd_word(screen->file_, kColours);
  screen->row_bytes_ = xwd_word(screen->file_, kBytesPerLine);
  const size_t end = screen->pixels_at_ + screen->row_bytes_ * static_cast<size_t>(height);
  if (xwd_word(screen->file_, kBitsPerPixel) != 32 || screen->row_bytes_ < 4 * static_cast<size_t>(width) ||
      end > screen->file_bytes_)
    return no_screen("a framebuffer of another format");
  return screen;
}

Screen::~Screen() {
  mouse_.reset();
  if (file_ != nullptr) munmap(const_cast<std::byte*>(file_), file_bytes_);
}

std::span<const uint32_t> Screen::row(int y) const {
  const std::byte* const at =
      file_ + pixels_at_ + row_bytes_ * static_cast<size_t>(y) + 4 * static_cast<size_t>(area_.x);
  return {reinterpret_cast<const uint32_t*>(at), static_cast<size_t>(area_.width)};
}

void Screen::watch(const Area& area, std::vector<Area> except) {
  area_ = area;
  except_ = std::move(except);
  remember();
}

void Screen::remember() {
  remembered_.clear();
  for (int y = 0; y < area_.height; y += kRowStep) {
    const auto pixels = row(area_.y + y);
    remembered_.insert(remembered_.end(), pixels.begin(), pixels.end());
  }
}

bool Screen::differs() const {
  const auto width = static_cast<size_t>(area_.width);
  int count = 0;
  for (int y = 0; y < area_.height; y += kRowStep) {
    const auto now = row(area_.y + y);
    const uint32_t* const then = &remembered_[static_cast<size_t>(y / kRowStep) * width];
    if (std::equal(now.begin(), now.end(), then)) continue;
    for (int x = 0; x < area_.width; ++x) {
      if (now[static_cast<size_t>(x)] == then[x]) continue;
      const bool counts = std::none_of(except_.begin(), except_.end(), [&](const Area& not_here) {
        const int px = area_.x + x - not_here.x, py = area_.y + y - not_here.y;
        return px >= 0 && py >= 0 && px < not_here.width && py < not_here.height;
      });
      if (counts && ++count >= kPatch) return true;
    }
  }
  return false;
}

Screen::Seen Screen::wait_for_change(double seconds) {
  const auto start = Clock::now();
  auto last = start;
  for (bool first = true; seconds_since(start) < seconds; first = false) {
    const bool changed = differs();
    const auto now = Clock::now();
    if (!first) looks_.push_back(1e3 * std::chrono::duration<double>(now - last).count());
    last = now;
    if (changed) return {true, now};
    std::this_thread::sleep_for(kLook);
  }
  return {};
}

bool Screen::wait_for_rest(double rest, double seconds) {
  const auto start = Clock::now();
  auto since = start;
  remember();
  while (seconds_since(start) < seconds) {
    if (differs()) {
      remember();
      since = Clock::now();
    }
    if (seconds_since(since) >= rest) return true;
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
  }
  return false;
}

}  // namespace vamp
