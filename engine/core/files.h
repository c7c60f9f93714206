#pragma once
// Reading whole files with a limit, writing them atomically, and where the program keeps its own.
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

#include "engine/core/error.h"

namespace vamp {

namespace fs = std::filesystem;

// The whole file; bad_input when it is missing or larger than `limit` bytes, io when reading fails.
Result<std::vector<std::byte>> read_file(const fs::path& path, uint64_t limit);
Result<std::string> read_text(const fs::path& path, uint64_t limit);

// Temporary file in the same folder, fsync, rename: the old file stays whole until the new one is complete, keeps its
// mode, and a symbolic link to it stays a link. Devices and pipes are written to directly. io when anything fails.
Status write_file_atomically(const fs::path& path, std::span<const std::byte> bytes);
Status write_text_atomically(const fs::path& path, std::string_view text);

// `relative` inside `base`, or bad_input: no absolute path, no scheme, no "..", no symbolic link that leaves `base`.
// `file` and `place` say who asked.
Result<fs::path> resolve_inside(const fs::path& base, std::string_view relative, std::string_view file,
                                std::string_view place);

// XDG base directories with "/vamp" appended; environment values that are not absolute are ignored.
fs::path config_dir();  // settings
fs::path state_dir();   // layout, recent files, autosaves
fs::path data_dir();    // the user's presets
fs::path cache_dir();   // thumbnails, tuning

// Folders of the program's own data (presets/, scenes/): VAMP_DATA, else beside or above the executable, else the
// source folder. Empty when none is found.
fs::path shipped_dir(std::string_view name);

}  // namespace vamp
