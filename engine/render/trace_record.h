#pragma once
// What was measured of devices and versions of their drivers, in `devices.json` of the program's cache.
#include <optional>

namespace vamp {

namespace gpu {
struct DeviceInfo;
}

// Of the same rays in two ways, in the order of the choices of TracePaths.
struct Timings {
  double first_ms = 0, second_ms = 0;
};

struct TraceRecord {
  std::optional<Timings> fetch, rays;
};

// A file that is not there, damaged or of another driver says nothing.
TraceRecord recall_traces(const gpu::DeviceInfo& device);
// In place of what was known of the device, also with other drivers. What cannot be written is only logged.
void remember_traces(const gpu::DeviceInfo& device, const TraceRecord& record);

}  // namespace vamp
