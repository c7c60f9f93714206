#include "engine/render/trace_record.h"

#include <string>
#include <vector>

#include "engine/core/files.h"
#include "engine/core/json.h"
#include "engine/core/log.h"
#include "engine/gpu/device_info.h"

namespace vamp {
namespace {

constexpr uint64_t kMaxBytes = 1u << 16;
constexpr size_t kMaxDevices = 32;

struct Remembered {
  std::string device, driver;  // DeviceInfo::name and driver, which hold the driver's version
  TraceRecord record;
};

fs::path file_of_devices() { return cache_dir() / "devices.json"; }

std::optional<Timings> read_timings(const JsonReader& device, const char* first, const char* second) {
  constexpr double kLeast = 1e-6, kMost = 1e6;
  if (!device.has(first)) return std::nullopt;
  return Timings{device.member(first).real(kLeast, kMost), device.member(second).real(kLeast, kMost)};
}

Result<std::vector<Remembered>> read_devices() {
  const std::string file = file_of_devices().string();
  VAMP_TRY(const std::string text, read_text(file, kMaxBytes));
  VAMP_TRY(const Json json, parse_json(text, file));
  const JsonReader root(json, file);
  const JsonReader devices = root.member("devices");
  std::vector<Remembered> all;
  for (size_t i = 0; i < devices.size(kMaxDevices); ++i) {
    const JsonReader one = devices.element(i);
    all.push_back({one.member("device").text(),
                   one.member("driver").text(),
                   {read_timings(one, "texel_ms", "storage_ms"), read_timings(one, "own_ms", "query_ms")}});
  }
  VAMP_CHECK_STATUS(root.status());
  return all;
}

Status write_devices(const std::vector<Remembered>& all) {
  Json devices = Json::array();
  for (const auto& [device, driver, record] : all) {
    Json& one = devices.emplace_back(Json{{"device", device}, {"driver", driver}});
    const auto add = [&one](const std::optional<Timings>& timings, const char* first, const char* second) {
      if (!timings) return;
      one[first] = timings->first_ms;
      one[second] = timings->second_ms;
    };
    add(record.fetch, "texel_ms", "storage_ms");
    add(record.rays, "own_ms", "query_ms");
  }
  std::error_code code;
  fs::create_directories(file_of_devices().parent_path(), code);
  return write_text_atomically(file_of_devices(), print_json(Json{{"devices", devices}}));
}

}  // namespace

TraceRecord recall_traces(const gpu::DeviceInfo& device) {
  if (const auto all = read_devices())
    for (const Remembered& one : *all)
      if (one.device == device.name && one.driver == device.driver) return one.record;
  return {};
}

void remember_traces(const gpu::DeviceInfo& device, const TraceRecord& record) {
  std::vector<Remembered> all = read_devices().value_or(std::vector<Remembered>());
  // Of a driver that was replaced nothing is kept.
  std::erase_if(all, [&](const Remembered& one) { return one.device == device.name; });
  if (all.size() >= kMaxDevices) all.erase(all.begin());
  all.push_back({device.name, device.driver, record});
  if (const Status written = write_devices(all); !written) spdlog::debug("{}", written.error().message());
}

}  // namespace vamp
