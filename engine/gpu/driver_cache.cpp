#include "engine/gpu/driver_cache.h"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <string>

namespace vamp::gpu {
namespace {

const char* variable(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr && *value != '\0' ? value : nullptr;
}

bool switched_off(const char* name) {
  const char* value = variable(name);
  if (value == nullptr) return false;
  const std::string text(value);
  return text == "1" || text == "true" || text == "yes" || text == "y" || text == "TRUE";
}

// Mesa's src/util/disk_cache_os.c, disk_cache_generate_cache_dir().
fs::path base_of_cache() {
  for (const char* name : {"MESA_SHADER_CACHE_DIR", "MESA_GLSL_CACHE_DIR", "XDG_CACHE_HOME"})
    if (const char* folder = variable(name)) return folder;
  if (const char* home = variable("HOME")) return fs::path(home) / ".cache";
  return {};
}

}  // namespace

fs::path driver_cache_dir() {
  if (switched_off("MESA_SHADER_CACHE_DISABLE") || switched_off("MESA_GLSL_CACHE_DISABLE")) return {};
  const fs::path base = base_of_cache();
  if (base.empty()) return {};
  const fs::path folder = base / "mesa_shader_cache";
  return ::access(folder.c_str(), R_OK | W_OK | X_OK) == 0 ? folder : fs::path();
}

fs::file_time_type last_change(const fs::path& driver_cache) {
  std::error_code code;
  fs::file_time_type last = fs::last_write_time(driver_cache, code);
  // A kernel is a file in one of 256 folders; newer Mesa appends to files in the folder itself.
  for (fs::directory_iterator at(driver_cache, code), end; !code && at != end; at.increment(code)) {
    std::error_code gone;
    const fs::file_time_type time = at->last_write_time(gone);
    if (!gone) last = std::max(last, time);
  }
  return last;
}

}  // namespace vamp::gpu
