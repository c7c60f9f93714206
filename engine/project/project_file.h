#pragma once
// Project files: *.vampproj, JSON, lengths in mm, angles in degrees, paths relative to the file.
#include <filesystem>

#include "engine/core/json.h"
#include "engine/project/file_reference.h"
#include "engine/project/project.h"

namespace vamp {

// Loads the model, the presets and the environment it names. A preset whose checksum differs is an error that says so;
// a missing one names the part that needs it. A model that has changed since is taken as it is now: parts are found by
// name, new ones show their own material; the log says so.
Result<Project> load_project(const std::filesystem::path& path);

// Atomic. Files are named by paths relative to the project file where they lie below its folder, else
// "shipped:presets/calf.vamp" or "library:cognac.vamp". One that lies elsewhere is an error that names it; nothing is
// written then. See outside_files and collect_files.
Status save_project(const Project& project, const std::filesystem::path& path);

// The files that keep a project from being saved at `path`: outside its folder, not shipped, not in the library.
std::vector<std::filesystem::path> outside_files(const Project& project, const std::filesystem::path& path);

// Copies those files into "<name of the project>_files" beside it (a .gltf with the buffers and images it names), and
// returns the project that uses the copies. Existing files of other content are never overwritten: the copy gets
// another name.
Result<Project> collect_files(const Project& project, const std::filesystem::path& path);

// The document as JSON as it is written in `folder`; and back. Used by project files, snapshots and autosaves alike,
// see PathUse. A project that validate() refuses is not written.
Result<Json> project_to_json(const Project& project, const std::filesystem::path& folder, PathUse use);
Result<Project> project_from_json(const JsonReader& reader, const std::filesystem::path& folder, std::string_view file,
                                  PathUse use);

// A scene argument of the command line: .vampproj, .gltf or .glb.
Result<Project> open_scene(const std::filesystem::path& path);

}  // namespace vamp
