#include "app/commands/preset_output.h"

#include <fmt/format.h>
#include <unistd.h>

#include "engine/material/preset.h"

namespace vamp {

Status check_preset_output(const fs::path& path, std::string_view name) {
  std::error_code code;
  const std::string extension = path.extension().string();
  const bool is_folder = fs::is_directory(path, code);
  if (name.size() > kMaxPresetName)
    return fail(ErrorKind::usage, "", "--name", fmt::format("at most {} bytes", kMaxPresetName),
                std::to_string(name.size()));
  if (extension == ".vamp" && is_folder) return fail(ErrorKind::io, path.string(), "", "a file", "a folder");
  // Without .vamp it is a folder that is made: a name mistyped, that of a picture or of the measurement, is none.
  if (extension != ".vamp" && !is_folder && !extension.empty())
    return fail(ErrorKind::usage, path.string(), "", "a name that ends with .vamp, or without extension for a folder",
                "\"" + extension + "\"");
  if (extension.empty() && !is_folder && fs::exists(path, code))
    return fail(ErrorKind::io, path.string(), "", "a name that ends with .vamp, or a folder", "another file");
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  if (!fs::is_directory(folder, code)) return fail(ErrorKind::io, path.string(), "", "a folder that exists", "none");
  if (::access(folder.c_str(), W_OK | X_OK) != 0)
    return fail(ErrorKind::io, path.string(), "", "a place that may be written to", "no permission");
  return {};
}

}  // namespace vamp
