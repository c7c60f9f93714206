#include "app/commands/interrupt.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <future>

#include "engine/core/progress.h"

namespace vamp {
namespace {

volatile std::sig_atomic_t stop_asked = 0;

void ask_to_stop(int) { stop_asked = 1; }

// ", 3 min 20 s left" of a stage, once enough of it is done to tell; a stage may begin part of the way.
class TimeLeft {
 public:
  std::string operator()(const std::string& stage, double fraction) {
    if (stage != stage_ || fraction < from_)
      stage_ = stage, from_ = fraction, start_ = std::chrono::steady_clock::now();
    const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start_;
    if (elapsed.count() < 3 || fraction - from_ < 0.01) return "";
    const auto left = std::lround(elapsed.count() * (1 - fraction) / (fraction - from_));
    return left >= 60 ? fmt::format(", {} min {} s left", left / 60, left % 60) : fmt::format(", {} s left", left);
  }

 private:
  std::string stage_;
  double from_ = 0;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace

void catch_interrupts() {
  struct sigaction action {};
  action.sa_handler = ask_to_stop;
  sigemptyset(&action.sa_mask);
  action.sa_flags = static_cast<int>(SA_RESETHAND | SA_RESTART);
  sigaction(SIGINT, &action, nullptr);
  sigaction(SIGTERM, &action, nullptr);
}

bool interrupted() { return stop_asked != 0; }

void run_with_progress(const std::string& label, Progress& progress, const std::function<void()>& work) {
  auto done = std::async(std::launch::async, work);
  const bool terminal = isatty(STDERR_FILENO) != 0;
  size_t width = 0;
  TimeLeft time_left;
  while (done.wait_for(std::chrono::milliseconds(50)) != std::future_status::ready) {
    if (interrupted()) progress.cancel();
    if (!terminal) continue;
    const std::string stage = progress.stage();
    const auto fraction = static_cast<double>(progress.fraction());
    const std::string line = fmt::format("{}{}{} {:3.0f} %{}", label, stage.empty() ? "" : ": ", stage, 100 * fraction,
                                         time_left(stage, fraction));
    // A shorter line leaves nothing of a longer one standing.
    fmt::print(stderr, "\r{:{}}", line, width);
    width = std::max(width, line.size());
  }
  // The line makes room for the result.
  if (terminal) fmt::print(stderr, "\r{:{}}\r", "", width);
  done.get();
}

}  // namespace vamp
