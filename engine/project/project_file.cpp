#include "engine/project/project_file.h"

#include "engine/core/files.h"
#include "engine/core/text.h"
#include "engine/project/file_reference.h"

namespace vamp {
namespace {

constexpr uint64_t kMaxProjectBytes = 64 << 20;

}  // namespace

Result<Project> load_project(const fs::path& path) {
  VAMP_TRY(const std::string text, read_text(path, kMaxProjectBytes));
  VAMP_TRY(const Json json, parse_json(text, path.string()));
  return project_from_json(JsonReader(json, path.string()), folder_of(path), path.string(), PathUse::portable);
}

Status save_project(const Project& project, const fs::path& path) {
  VAMP_TRY(const Json json, project_to_json(project, folder_of(path), PathUse::portable));
  return write_text_atomically(path, print_json(json));
}

Result<Project> open_scene(const fs::path& path) {
  const std::string extension = lower_extension(path);
  if (extension == ".vampproj") return load_project(path);
  if (extension != ".gltf" && extension != ".glb")
    return fail(ErrorKind::bad_input, path.string(), "", "a scene: .vampproj, .gltf or .glb",
                extension.empty() ? "a name without an extension" : "\"" + extension + "\"");
  VAMP_TRY(auto scene, load_scene(path));
  return make_project(std::move(scene), path);
}

}  // namespace vamp
