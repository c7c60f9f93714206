#pragma once
// How kernels trace a scene, where drivers differ by a factor of two in both directions: through what they fetch it,
// and whose rays they are. Measured once for each device and version of its driver, and remembered in the program's
// cache.
#include <optional>
#include <string>

#include "engine/core/error.h"
#include "engine/render/kernel_key.h"

namespace vamp {

namespace gpu {
class Device;
struct DeviceInfo;
}  // namespace gpu

// Of two ways.
struct Choice {
  enum class Reason { only, assumed, measured, forced };  // only: the device knows no other
  Reason reason = Reason::assumed;
  bool second = false;
  double first_ms = 0, second_ms = 0;  // of the same rays, where it was measured
};

struct TracePaths {
  Choice fetch;  // texel buffers, or storage buffers: the picture is the same bytes
  Choice rays;   // the program's own tree, or the device's ray queries: the same but where triangles touch
  TracePath chosen() const { return {fetch.second, rays.second}; }
};

// VAMP_FETCH=texel or storage, VAMP_RAYS=own or query in the environment, else what is remembered, else what is likely.
// Reads a small file.
TracePaths trace_paths(const gpu::DeviceInfo& device);

// Measures what is neither remembered nor forced now: about a second where the kernels are not in the driver's cache.
// What cannot be written is measured again the next time; a device that fails at it keeps what is likely. Nothing may
// be in flight.
void tune_trace_paths(gpu::Device& device);

// "fetches through texel buffers: 5.1 ms for what storage buffers take 8.3 ms for; traces by ..."
std::string words_of(const TracePaths& paths);

}  // namespace vamp
