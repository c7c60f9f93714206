#include "engine/core/log.h"

#include <spdlog/sinks/ringbuffer_sink.h>
#include <spdlog/sinks/stdout_sinks.h>

#include <memory>

namespace vamp {
namespace {
std::shared_ptr<spdlog::sinks::ringbuffer_sink_mt> ring() {
  static auto sink = std::make_shared<spdlog::sinks::ringbuffer_sink_mt>(500);
  return sink;
}
}  // namespace

void start_log(const std::string& level) {
  auto to_stderr = std::make_shared<spdlog::sinks::stderr_sink_mt>();
  auto logger = std::make_shared<spdlog::logger>("vamp", spdlog::sinks_init_list{to_stderr, ring()});
  logger->set_pattern("vamp: %l: %v");
  logger->set_level(spdlog::level::from_str(level));
  spdlog::set_default_logger(std::move(logger));
}

std::vector<LogLine> recent_log() {
  std::vector<LogLine> lines;
  for (const auto& entry : ring()->last_raw())
    lines.push_back({static_cast<int>(entry.level), std::string(entry.payload.data(), entry.payload.size())});
  return lines;
}

std::vector<std::string> warnings_since(std::chrono::system_clock::time_point start) {
  std::vector<std::string> lines;
  for (const auto& entry : ring()->last_raw())
    if (entry.level >= spdlog::level::warn && entry.time >= start)
      lines.emplace_back(entry.payload.data(), entry.payload.size());
  return lines;
}

}  // namespace vamp
