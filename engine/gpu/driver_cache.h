#pragma once
// The folders in which Mesa keeps the kernels that it has compiled.
#include <vector>

#include "engine/core/files.h"

namespace vamp::gpu {

// Empty where Mesa keeps none: switched off, or folders that cannot be written. Ask once a device is open: that makes
// the folder. Two where drivers of different age have run: which is this one's cannot be seen.
std::vector<fs::path> driver_caches();

// Changes when something is written there. Mesa writes some time after a kernel was compiled, on a thread of the least
// priority.
fs::file_time_type last_change(const std::vector<fs::path>& driver_caches);

}  // namespace vamp::gpu
