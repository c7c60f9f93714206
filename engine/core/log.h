#pragma once
// One log for the program: human text to stderr (stdout belongs to results), the last lines kept for the log panel.
#include <spdlog/spdlog.h>

#include <chrono>
#include <string>
#include <vector>

namespace vamp {

struct LogLine {
  int level = 0;  // spdlog::level::level_enum
  std::string text;
};

// Sets up stderr and the ring of recent lines; call once at the start. level: trace, debug, info, warn, error, off.
void start_log(const std::string& level);

// The last lines, oldest first, at most 500.
std::vector<LogLine> recent_log();

// Those of them that are warnings or worse and were said since then.
std::vector<std::string> warnings_since(std::chrono::system_clock::time_point start);

}  // namespace vamp
