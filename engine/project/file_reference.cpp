#include "engine/project/file_reference.h"

#include <algorithm>
#include <optional>

#include "engine/core/files.h"
#include "engine/project/known_files.h"

namespace vamp {
namespace {

constexpr std::string_view kShipped = "shipped:";
constexpr std::string_view kLibrary = "library:";
constexpr std::string_view kShippedFolders[] = {"presets", "scenes"};

bool has_scheme(std::string_view name) { return name.starts_with(kShipped) || name.starts_with(kLibrary); }

// Absolute, with symbolic links of the folders resolved, so that one file has one name.
fs::path real_path(const fs::path& path) {
  std::error_code code;
  const fs::path whole = fs::weakly_canonical(fs::absolute(path, code), code);
  return code ? path : whole;
}

// `path` relative to `folder` where it lies below it. Both canonical.
std::optional<std::string> below(const fs::path& path, const fs::path& folder) {
  if (folder.empty()) return std::nullopt;
  const auto [folder_end, path_rest] = std::mismatch(folder.begin(), folder.end(), path.begin(), path.end());
  if (folder_end != folder.end() || path_rest == path.end()) return std::nullopt;
  fs::path rest;
  for (auto step = path_rest; step != path.end(); ++step) rest /= *step;
  return rest.generic_string();
}

}  // namespace

fs::path folder_of(const fs::path& document) {
  std::error_code code;
  const fs::path full = fs::absolute(document, code);
  return (code ? document : full).parent_path();
}

fs::path preset_library_dir() { return data_dir() / "presets"; }

std::string make_reference(const fs::path& path) {
  if (path.empty() || has_scheme(path.string())) return path.string();
  const fs::path whole = real_path(path);
  for (const std::string_view folder : kShippedFolders) {
    const fs::path shipped = shipped_dir(folder);
    if (shipped.empty()) continue;
    if (const auto rest = below(whole, real_path(shipped)))
      return std::string(kShipped) + std::string(folder) + "/" + *rest;
  }
  if (const auto rest = below(whole, real_path(preset_library_dir()))) return std::string(kLibrary) + *rest;
  return whole.string();
}

Result<fs::path> path_of_reference(std::string_view reference, std::string_view file, std::string_view place) {
  if (reference.starts_with(kLibrary))
    return resolve_inside(preset_library_dir(), reference.substr(kLibrary.size()), file, place);
  if (!reference.starts_with(kShipped)) return fs::path(reference);
  const std::string_view rest = reference.substr(kShipped.size());
  const std::string_view folder = rest.substr(0, rest.find('/'));
  if (std::find(std::begin(kShippedFolders), std::end(kShippedFolders), folder) == std::end(kShippedFolders) ||
      folder.size() == rest.size())
    return fail(ErrorKind::bad_input, file, place, "shipped:presets/... or shipped:scenes/...",
                "\"" + std::string(reference) + "\"");
  const fs::path shipped = shipped_dir(folder);
  if (shipped.empty())
    return fail(ErrorKind::bad_input, file, place, "the program's own " + std::string(folder) + " folder",
                "none beside the program");
  return resolve_inside(shipped, rest.substr(folder.size() + 1), file, place);
}

Result<std::string> stored_name(std::string_view reference, std::string_view checksum, const fs::path& folder,
                                PathUse use, std::string_view place) {
  if (reference.empty()) return fail(ErrorKind::failed, "", place, "a file", "nothing that was ever saved to one");
  if (use == PathUse::local || has_scheme(reference)) return std::string(reference);
  const fs::path path = real_path(fs::path(reference));
  // Remembered wherever it lies: pictures are moved away from what they show.
  if (use == PathUse::job && !checksum.empty()) remember_file(checksum, path);
  if (const auto rest = below(path, real_path(folder))) return has_scheme(*rest) ? "./" + *rest : *rest;
  if (use == PathUse::job) return path.filename().string();
  return fail(ErrorKind::failed, path.string(), place,
              "a file inside the project's folder, so that the project can be moved and passed on",
              "it lies outside " + real_path(folder).string());
}

Result<std::string> reference_from_stored(std::string_view stored, std::string_view checksum, const fs::path& folder,
                                          PathUse use, std::string_view file, std::string_view place) {
  if (has_scheme(stored)) {
    VAMP_CHECK_STATUS(path_of_reference(stored, file, place).map([](const fs::path&) {}));
    return std::string(stored);
  }
  if (use == PathUse::local && fs::path(stored).is_absolute()) return std::string(stored);
  VAMP_TRY(const fs::path beside, resolve_inside(folder, stored, file, place));
  if (use != PathUse::job || checksum.empty()) return make_reference(beside);

  // A job's picture is only the same with the same file, wherever that is found.
  std::error_code code;
  const bool there = fs::exists(beside, code);
  if (there && (fs::is_directory(beside, code) || file_checksum(beside).value_or("") == checksum))
    return make_reference(beside);
  if (const auto known = known_file(checksum)) return make_reference(*known);
  if (there) return make_reference(beside);  // whoever loads it says that it has changed
  return fail(ErrorKind::bad_input, file, place, "the file \"" + std::string(stored) + "\" beside it",
              "neither there nor among the files opened before");
}

}  // namespace vamp
