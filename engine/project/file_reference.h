#pragma once
// How projects name the files they need.
//
// In memory a file is a reference: "shipped:presets/calf.vamp" (part of the program), "library:cognac.vamp" (in the
// user's preset library) or an absolute path. What is written depends on where the document goes:
//   portable  project files: shipped, library, or a path relative to the document's folder; files outside are refused
//   job       snapshots: as portable, but a file outside is written as its bare name, to be found by its checksum
//             among the files that this user's program has had open (known_files.h)
//   local     autosaves in state_dir(), which never leave the machine: absolute paths as they are
#include <filesystem>
#include <string>
#include <string_view>

#include "engine/core/error.h"

namespace vamp {

enum class PathUse { portable, job, local };

// The reference of a file on disk; "" stays "", references stay what they are, relative paths start at the working
// folder.
std::string make_reference(const std::filesystem::path& path);

// Where a reference lies on this machine; bad_input when a shipped or library file would lie outside its folder.
Result<std::filesystem::path> path_of_reference(std::string_view reference, std::string_view file,
                                                std::string_view place);

// What a document in `folder` writes for `reference`. `checksum` may be empty; with it a job's file is remembered.
Result<std::string> stored_name(std::string_view reference, std::string_view checksum,
                                const std::filesystem::path& folder, PathUse use, std::string_view place);

// The reference that a document in `folder` means by `stored`. Whether something is there is seen when it is read,
// except for a job's files, which are looked for.
Result<std::string> reference_from_stored(std::string_view stored, std::string_view checksum,
                                          const std::filesystem::path& folder, PathUse use, std::string_view file,
                                          std::string_view place);

// The folder that a document lies in; as given where the working folder is gone.
std::filesystem::path folder_of(const std::filesystem::path& document);

// The user's preset library, which "library:" stands for.
std::filesystem::path preset_library_dir();

}  // namespace vamp
