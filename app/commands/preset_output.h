#pragma once
// Where a verb writes a preset.
#include <string_view>

#include "engine/core/error.h"
#include "engine/core/files.h"

namespace vamp {

// Why a preset could not be written there under this name, before minutes are spent on it: usage for what is no
// preset's name, io for places.
Status check_preset_output(const fs::path& path, std::string_view name);

}  // namespace vamp
