#include "app/commands/interrupt.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <future>

#include "engine/core/progress.h"

namespace vamp {
namespace {

volatile std::sig_atomic_t stop_asked = 0;

void ask_to_stop(int) { stop_asked = 1; }

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
  while (done.wait_for(std::chrono::milliseconds(50)) != std::future_status::ready) {
    if (interrupted()) progress.cancel();
    if (!terminal) continue;
    const std::string stage = progress.stage();
    const std::string line = fmt::format("{}{}{} {:3.0f} %", label, stage.empty() ? "" : ": ", stage,
                                         100.0 * static_cast<double>(progress.fraction()));
    // A shorter line leaves nothing of a longer one standing.
    fmt::print(stderr, "\r{:{}}", line, width);
    width = std::max(width, line.size());
  }
  // The line makes room for the result.
  if (terminal) fmt::print(stderr, "\r{:{}}\r", "", width);
  done.get();
}

}  // namespace vamp
