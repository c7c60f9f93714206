#include "engine/gpu/driver_cache.h"

#include <unistd.h>

#include <algorithm>
#include <cctype>
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
  std::string text(value);
  std::transform(text.begin(), text.end(), text.begin(), [](unsigned char c) { return std::tolower(c); });
  return text == "1" || text == "true" || text == "yes" || text == "y";
}

// Mesa's src/util/disk_cache_os.c, disk_cache_generate_cache_dir().
fs::path base_of_cache() {
  for (const char* name : {"MESA_SHADER_CACHE_DIR", "MESA_GLSL_CACHE_DIR", "XDG_CACHE_HOME"})
    if (const char* folder = variable(name)) return folder;
  if (const char* home = variable("HOME")) return fs::path(home) / ".cache";
  return {};
}

}  // namespace

std::vector<fs::path> driver_caches() {
  if (switched_off("MESA_SHADER_CACHE_DISABLE") || switched_off("MESA_GLSL_CACHE_DISABLE")) return {};
  const fs::path base = base_of_cache();
  std::vector<fs::path> folders;
  if (base.empty()) return folders;
  for (const char* name : {"mesa_shader_cache", "mesa_shader_cache_db"})
    if (const fs::path folder = base / name; ::access(folder.c_str(), R_OK | W_OK | X_OK) == 0)
      folders.push_back(folder);
  return folders;
}

fs::file_time_type last_change(const std::vector<fs::path>& driver_caches) {
  // A kernel is a file in one of 256 folders; newer Mesa appends to files, in the folder itself or in one below.
  constexpr int kMostEntries = 1024;
  fs::file_time_type last = fs::file_time_type::min();
  for (const fs::path& folder : driver_caches) {
    const bool appends = folder.filename() == "mesa_shader_cache_db";
    std::error_code code;
    int left = kMostEntries;
    for (fs::recursive_directory_iterator at(folder, code), end; !code && at != end && left > 0; at.increment(code)) {
      if (!appends) at.disable_recursion_pending();
      std::error_code gone;
      const fs::file_time_type time = at->last_write_time(gone);
      if (!gone) last = std::max(last, time);
      --left;
    }
  }
  return last;
}

}  // namespace vamp::gpu
