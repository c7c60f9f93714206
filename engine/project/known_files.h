#pragma once
// Which files this user's program has had open, by the checksum of what was in them. A snapshot's job names a file that
// lies elsewhere only by its name and checksum: pictures that are passed on tell nothing of the folders of the machine
// they were made on, and a picture that comes from elsewhere can only name what its user has opened before.
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "engine/core/error.h"

namespace vamp {

// Checksum of a whole file.
Result<std::string> file_checksum(const std::filesystem::path& path);

// Notes where a file is; kept in state_dir(), the latest 1,000. A note that cannot be written is only logged: the file
// itself is not needed for going on.
void remember_file(std::string_view checksum, const std::filesystem::path& path);

// Where it was last seen, if something is still there.
std::optional<std::filesystem::path> known_file(std::string_view checksum);

}  // namespace vamp
