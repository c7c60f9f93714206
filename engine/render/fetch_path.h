#pragma once
// Through what kernels fetch the scene's tree and triangles: texel buffers or storage buffers. Drivers differ by a
// factor of two, in both directions (lavapipe before and after Mesa 25); the picture is the same bytes. Measured once
// for each device and version of its driver, and remembered in the program's cache.
#include <optional>
#include <string>

#include "engine/core/error.h"

namespace vamp {

namespace gpu {
class Device;
struct DeviceInfo;
}  // namespace gpu

struct FetchPath {
  enum class Reason { assumed, measured, forced };
  Reason reason = Reason::assumed;
  bool storage = false;
  double texel_ms = 0, storage_ms = 0;  // of the same rays, where it was measured
};

// VAMP_FETCH=texel or storage in the environment, else what is remembered, else what is likely. Reads a small file.
FetchPath fetch_path(const gpu::DeviceInfo& device);

// Measures it now unless it is remembered or forced: about a second where the kernels are not in the driver's cache.
// What cannot be written is measured again the next time; a device that fails at it keeps what is likely. Nothing may
// be in flight.
void tune_fetch_path(gpu::Device& device);

// "texel buffers: 5.1 ms for what storage buffers take 8.3 ms for".
std::string words_of(const FetchPath& path);

}  // namespace vamp
