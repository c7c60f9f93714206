#include "engine/render/trace_path.h"

#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <string_view>

#include "engine/core/log.h"
#include "engine/gpu/device.h"
#include "engine/render/trace_probe.h"
#include "engine/render/trace_record.h"

namespace vamp {
namespace {

// What ways a kernel has, and how they are named.
struct Ways {
  const char* variable;
  const char* first_value;
  const char* second_value;
  const char* first_words;
  const char* second_words;
};
constexpr Ways kFetch = {"VAMP_FETCH", "texel", "storage", "texel buffers", "storage buffers"};
constexpr Ways kRays = {"VAMP_RAYS", "own", "query", "a tree of its own", "ray queries"};

// Pictures differ where triangles touch: for less than this, who asks for a picture again gets the one that he knows.
constexpr double kQueriesPay = 0.9;

Choice choose(const Ways& ways, const std::optional<Timings>& measured, double pays, bool likely) {
  const char* value = std::getenv(ways.variable);
  const std::string_view forced = value == nullptr ? "" : value;
  if (forced == ways.first_value || forced == ways.second_value)
    return {Choice::Reason::forced, forced == ways.second_value};
  if (measured)
    return {Choice::Reason::measured, measured->second_ms < pays * measured->first_ms, measured->first_ms,
            measured->second_ms};
  return {Choice::Reason::assumed, likely};
}

std::string words_of(const Choice& choice, const Ways& ways) {
  const char* const chosen = choice.second ? ways.second_words : ways.first_words;
  const char* const other = choice.second ? ways.first_words : ways.second_words;
  switch (choice.reason) {
    case Choice::Reason::only:
      return chosen;
    case Choice::Reason::forced:
      return fmt::format("{}, by {}", chosen, ways.variable);
    case Choice::Reason::measured:
      return fmt::format("{}: {:.1f} ms for what {} take{} {:.1f} ms for", chosen,
                         choice.second ? choice.second_ms : choice.first_ms, other,
                         std::string_view(other) == kRays.first_words ? "s" : "",
                         choice.second ? choice.first_ms : choice.second_ms);
    case Choice::Reason::assumed:
      break;
  }
  return fmt::format("{}, not measured yet", chosen);
}

}  // namespace

TracePaths trace_paths(const gpu::DeviceInfo& device) {
  const TraceRecord record = recall_traces(device);
  TracePaths paths;
  paths.fetch = choose(kFetch, record.fetch, 1, !(device.is_lavapipe && device.driver_major < 25));
  if (device.ray_queries)
    paths.rays = choose(kRays, record.rays, kQueriesPay, !device.is_cpu);
  else
    paths.rays.reason = Choice::Reason::only;
  return paths;
}

void tune_trace_paths(gpu::Device& device) {
  const TracePaths now = trace_paths(device.info());
  if (now.fetch.reason != Choice::Reason::assumed && now.rays.reason != Choice::Reason::assumed) return;
  try {
    TraceRecord record;
    record.fetch = time_traces(device, {false, false}, {true, false});
    const bool storage = record.fetch->second_ms < record.fetch->first_ms;
    if (device.info().ray_queries) record.rays = time_traces(device, {storage, false}, {storage, true});
    remember_traces(device.info(), record);
  } catch (const MachineError& error) {
    // What is assumed then serves as well.
    spdlog::debug("{}", error.what());
  }
}

std::string words_of(const TracePaths& paths) {
  return fmt::format("fetches through {}; traces by {}", words_of(paths.fetch, kFetch), words_of(paths.rays, kRays));
}

}  // namespace vamp
