#pragma once
// Project files (*.vampproj, JSON, relative paths only) and jobs (the same document inside a snapshot's metadata).
#include <filesystem>

#include "engine/core/json.h"
#include "engine/project/project.h"

namespace vamp {

// Loads the model, the presets and the environment it names. A preset whose checksum differs is an error that says so;
// a missing one names the part that needs it.
Result<Project> load_project(const std::filesystem::path& path);

// Atomic. Paths are stored relative to the file where they lie below its folder or are shipped with the program
// ("shipped:presets/calf.vamp"); otherwise the user is told which file lies outside.
Status save_project(const Project& project, const std::filesystem::path& path);

// The document as JSON, paths relative to `folder`; and back. Used by files, snapshots and autosaves alike.
Json project_to_json(const Project& project, const std::filesystem::path& folder);
Result<Project> project_from_json(const Json& json, const std::filesystem::path& folder, std::string_view file);

// A scene argument of the command line: .vampproj, .gltf or .glb.
Result<Project> open_scene(const std::filesystem::path& path);

}  // namespace vamp
