#pragma once
// The folder in which Mesa keeps the kernels that it has compiled.
#include "engine/core/files.h"

namespace vamp::gpu {

// Empty where Mesa keeps none: switched off, or a folder that cannot be written. Ask once a device is open: that makes
// the folder.
fs::path driver_cache_dir();

// Changes when something is written there. Mesa writes some time after a kernel was compiled, on a thread of the least
// priority.
fs::file_time_type last_change(const fs::path& driver_cache);

}  // namespace vamp::gpu
