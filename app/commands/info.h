#pragma once
// What `vamp info` knows of each kind of file, as one JSON object; its members stand in the order in which people read
// them.
#include "engine/core/files.h"
#include "engine/core/json.h"

namespace vamp {

Result<Json> model_info(const fs::path& path);
Result<Json> project_info(const fs::path& path);
Result<Json> preset_info(const fs::path& path);
Result<Json> picture_info(const fs::path& path);
Result<Json> btf_info(const fs::path& path);

// What `vamp info` prints of a file.
Status print_info(const fs::path& path, bool json);

}  // namespace vamp
