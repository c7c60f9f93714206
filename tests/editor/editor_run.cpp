#include "tests/editor/editor_run.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <thread>

#include "engine/image/load.h"

namespace vamp::editor_test {
namespace {

void sleep_ms(int ms) { std::this_thread::sleep_for(std::chrono::milliseconds(ms)); }

pid_t start(const std::vector<std::string>& words, const std::vector<std::string>& variables, const fs::path& folder,
            int out, int err) {
  const pid_t child = fork();
  if (child != 0) return child;
  for (const std::string& variable : variables) putenv(const_cast<char*>(variable.c_str()));
  if (!folder.empty() && chdir(folder.c_str()) != 0) _exit(126);
  if (out >= 0) dup2(out, STDOUT_FILENO);
  if (err >= 0) dup2(err, STDERR_FILENO);
  std::vector<char*> arguments;
  for (const std::string& word : words) arguments.push_back(const_cast<char*>(word.c_str()));
  arguments.push_back(nullptr);
  execvp(arguments[0], arguments.data());
  _exit(127);
}

}  // namespace

std::string output_of(const std::string& command, int* code) {
  FILE* pipe = popen(command.c_str(), "r");
  if (pipe == nullptr) return "";
  std::string text;
  std::array<char, 4096> part{};
  for (size_t got = 0; (got = fread(part.data(), 1, part.size(), pipe)) > 0;) text.append(part.data(), got);
  const int status = pclose(pipe);
  if (code != nullptr) *code = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return text;
}

bool wait_until(const std::function<bool()>& holds, double seconds) {
  const auto until = std::chrono::steady_clock::now() + std::chrono::duration<double>(seconds);
  while (!holds()) {
    if (std::chrono::steady_clock::now() > until) return false;
    sleep_ms(50);
  }
  return true;
}

Display::Display() {
  if (output_of("command -v Xvfb && command -v xdotool && command -v import").empty()) return;
  int ends[2];
  if (pipe(ends) != 0) return;
  const int nothing = open("/dev/null", O_WRONLY);
  server_ = start({"Xvfb", "-displayfd", std::to_string(ends[1]), "-screen", "0",
                   fmt::format("{}x{}x24", kWidth, kHeight), "-nolisten", "tcp"},
                  {}, {}, nothing, nothing);
  close(nothing);
  close(ends[1]);
  std::string number;
  for (char c = 0; read(ends[0], &c, 1) == 1 && c != '\n';) number += c;
  close(ends[0]);
  if (!number.empty()) name_ = ":" + number;
}

Display::~Display() {
  if (server_ <= 0) return;
  kill(server_, SIGTERM);
  waitpid(server_, nullptr, 0);
}

std::vector<std::string> environment_of(const fs::path& home, const std::string& display) {
  std::vector<std::string> variables{"DISPLAY=" + display, "WAYLAND_DISPLAY="};
  for (const auto& [variable, folder] : {std::pair("XDG_CONFIG_HOME", "config"), std::pair("XDG_STATE_HOME", "state"),
                                         std::pair("XDG_DATA_HOME", "data"), std::pair("XDG_CACHE_HOME", "cache")})
    variables.push_back(fmt::format("{}={}", variable, (home / folder).string()));
  return variables;
}

EditorRun::EditorRun(const Display& display, const fs::path& home, const std::vector<std::string>& arguments, int width,
                     int height)
    : display_(display.name()), log_(home / "log"), home_(home) {
  std::vector<std::string> words{VAMP_PROGRAM, "--log-level", "debug",
                                 "edit",       "--size",      fmt::format("{}x{}", width, height)};
  words.insert(words.end(), arguments.begin(), arguments.end());
  const int log = open(log_.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  process_ = start(words, environment_of(home, display_), home, log, log);
  close(log);
}

EditorRun::~EditorRun() {
  if (running()) kill_hard();
}

std::string EditorRun::log() const { return read_text(log_, 1 << 24).value_or(""); }

bool EditorRun::shows_picture() {
  return wait_until([&] { return log().find("first whole sample") != std::string::npos || !running(); }, 120) &&
         running();
}

bool EditorRun::running() {
  if (process_ <= 0) return false;
  int status = 0;
  if (waitpid(process_, &status, WNOHANG) != process_) return true;
  code_ = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
  process_ = -1;
  return false;
}

int EditorRun::wait_for_end(double seconds) {
  wait_until([&] { return !running(); }, seconds);
  return code_;
}

void EditorRun::kill_hard() {
  if (process_ > 0) kill(process_, SIGKILL);
  wait_for_end();
}

std::string EditorRun::tool(const std::string& what) const {
  // A frame of the window lies between two acts, as with a hand.
  const std::string said = output_of("DISPLAY=" + display_ + " xdotool " + what);
  sleep_ms(120);
  return said;
}
void EditorRun::key(const std::string& keys) const { tool("key " + keys); }
void EditorRun::type(const std::string& text) const { tool("type --delay 40 '" + text + "'"); }
void EditorRun::move(int x, int y) const { tool(fmt::format("mousemove {} {}", x, y)); }
void EditorRun::click(int x, int y) const {
  move(x, y);
  tool("click 1");
}
void EditorRun::double_click(int x, int y) const {
  move(x, y);
  tool("click --repeat 2 --delay 80 1");
}
void EditorRun::drag(int x0, int y0, int x1, int y1) const {
  move(x0, y0);
  tool("mousedown 1");
  for (int step = 1; step <= 8; ++step) move(x0 + (x1 - x0) * step / 8, y0 + (y1 - y0) * step / 8);
  tool("mouseup 1");
}

Image EditorRun::screen() const {
  const fs::path file = home_ / "screen.png";
  output_of("DISPLAY=" + display_ + " import -window root " + file.string());
  return load_image(file, ColourSpace::linear).value_or(Image(1, 1, {"R", "G", "B"}));
}

}  // namespace vamp::editor_test
