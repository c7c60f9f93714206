#include "bench/window/editor_window.h"

#include <fmt/format.h>

#include <chrono>
#include <thread>

namespace vamp {
namespace {

constexpr int kPatience = 64;  // steps of a key, notches of the wheel

// Longer than a frame of the window and what follows from it.
void breathe() { std::this_thread::sleep_for(std::chrono::milliseconds(120)); }

std::vector<std::string> variables(const fs::path& home, const std::string& display) {
  // One driver's cache for all windows: the others start as a program does that was there before.
  std::vector<std::string> all{"DISPLAY=" + display, "WAYLAND_DISPLAY=", "HOME=" + home.string(),
                               "MESA_SHADER_CACHE_DIR=" + home.parent_path().string()};
  for (const char* const kind : {"CONFIG", "STATE", "DATA", "CACHE"})
    all.push_back(fmt::format("XDG_{}_HOME={}", kind, (home / kind).string()));
  return all;
}

}  // namespace

Result<std::unique_ptr<EditorWindow>> EditorWindow::open(Screen& screen, const fs::path& home, const fs::path& project,
                                                         int width, int height) {
  std::error_code code;
  const fs::path program = fs::read_symlink("/proc/self/exe", code);
  fs::create_directories(home, code);
  if (code) return fail(ErrorKind::io, home.string(), "", "a folder for the editor's settings", code.message());
  std::unique_ptr<EditorWindow> window(new EditorWindow(screen, home / "log"));
  VAMP_TRY(window->program_, Child::start({program.string(), "--log-level", "warn", "edit", "--tell", "--size",
                                           fmt::format("{}x{}", width, height), project.string()},
                                          variables(home, screen.display()), window->log_));
  if (!window->waits_for([](const Json& told) { return told.value("samples", 0) > 0; }, 120))
    return window->lost("a first whole sample");
  return window;
}

tl::unexpected<Error> EditorWindow::lost(std::string_view expected) {
  std::string said = read_text(log_, 1 << 20).value_or("");
  if (said.empty()) said = "it " + std::string(program_->running() ? "did not come to it" : "ended");
  return fail(ErrorKind::failed, "vamp edit", "", expected, said.substr(0, said.find('\n')));
}

const Json& EditorWindow::told() {
  const Child::Line line = program_->last_line();
  if (line.number == read_) return told_;
  read_ = line.number;
  if (auto parsed = parse_json(line.text, "vamp edit")) told_ = std::move(*parsed);
  return told_;
}

bool EditorWindow::waits_for(const std::function<bool(const Json&)>& holds, double seconds) {
  const auto start = Clock::now();
  while (!holds(told())) {
    const double left = seconds - seconds_since(start);
    if (left <= 0 || !program_->running()) return false;
    program_->line_after(read_, std::min(left, 1.0));
  }
  return true;
}

bool EditorWindow::has(const std::string& name) { return told().contains("places") && told()["places"].contains(name); }

Area EditorWindow::place(const std::string& name) {
  const Json& box = told()["places"][name];
  const auto at = [&](size_t i) { return static_cast<int>(box[i].get<double>()); };
  return {at(0), at(1), at(2) - at(0), at(3) - at(1)};
}

Area EditorWindow::viewport() { return place("Viewport"); }

Status EditorWindow::fit_viewport(int width, int height) {
  for (int attempt = 0; attempt < 3; ++attempt) {
    const Area now = viewport();
    if (now.width == width && now.height == height) return {};
    const Json& all = told()["window"];
    screen_.mouse().resize_window(all[0].get<int>() + width - now.width, all[1].get<int>() + height - now.height);
    waits_for([&](const Json&) { return viewport().width == width && viewport().height == height; }, 5);
  }
  return lost(fmt::format("a picture of {} x {}", width, height));
}

Status EditorWindow::step(Mouse::Key key, bool control, const char* what, int wanted) {
  for (int i = 0; i < kPatience && told().value(what, -1) != wanted; ++i) {
    const int before = told().value(what, -1);
    control ? screen_.mouse().key_with_control(key) : screen_.mouse().key(key);
    waits_for([&](const Json& told) { return told.value(what, -1) != before; }, 2);
  }
  return told().value(what, -1) == wanted ? Status{} : lost(fmt::format("{} {} selected", what, wanted));
}

Status EditorWindow::select(int part, int cluster) {
  // Keys go to the window below the pointer.
  const Area view = viewport();
  screen_.mouse().move(view.x + 4, view.y + view.height - 4);
  breathe();
  VAMP_CHECK_STATUS(step(Mouse::kPageDown, false, "part", part));
  return step(Mouse::kPageDown, true, "cluster", cluster);
}

void EditorWindow::click(const Area& place) {
  screen_.mouse().move(place.x + place.width / 2, place.y + place.height / 2);
  breathe();
  screen_.mouse().click();
  breathe();
}

Result<Area> EditorWindow::find(const std::string& panel, const std::string& name) {
  if (!has(panel)) return lost("a tab \"" + panel + "\"");
  const Area tab = place(panel);
  click(tab);
  screen_.mouse().move(tab.x + tab.width / 2, tab.y + tab.height + 40);
  breathe();
  // From the top down.
  for (int notch = 0; notch < kPatience && !has(name); ++notch) screen_.mouse().click(Mouse::kWheelUp);
  breathe();
  for (int notch = 0; notch < kPatience && !has(name); ++notch) {
    screen_.mouse().click(Mouse::kWheelDown);
    breathe();
  }
  if (!has(name)) return lost("\"" + name + "\" in " + panel);
  breathe();
  return place(name);
}

Status EditorWindow::choose(const std::string& panel, const std::string& list, const std::string& item) {
  VAMP_TRY(const Area row, find(panel, list));
  click(row);
  if (!waits_for([&](const Json&) { return has(item); }, 5)) return lost("\"" + item + "\" in a list");
  click(place(item));
  return {};
}

}  // namespace vamp
