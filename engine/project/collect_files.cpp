#include <set>

#include "engine/core/files.h"
#include "engine/project/known_files.h"
#include "engine/project/project_file.h"
#include "engine/scene/gltf_file.h"

namespace vamp {
namespace {

constexpr uint64_t kMaxGltfBytes = 64 << 20;
constexpr size_t kMaxGltfResources = 65536;

bool lies_outside(const std::string& reference, const fs::path& folder) {
  return !reference.empty() && !stored_name(reference, "", folder, PathUse::portable, "").has_value();
}

tl::unexpected<Error> cannot_copy(const fs::path& from, const fs::path& to, const std::string& why) {
  return fail(ErrorKind::io, from.string(), "", "cannot be copied to " + to.string() + ": " + why);
}

// The plain files that a .gltf names in its buffers and images; data URIs stay where they are. Names are
// percent-encoded in the file.
Result<std::vector<std::string>> gltf_resources(const fs::path& path) {
  VAMP_TRY(const std::string text, read_text(path, kMaxGltfBytes));
  // glTF may nest deeper and hold longer strings (data URIs) than the program's own documents.
  const Json json = Json::parse(text, nullptr, false);
  std::vector<std::string> names;
  for (const char* list : {"buffers", "images"}) {
    if (!json.is_object() || !json.contains(list) || !json.at(list).is_array()) continue;
    for (const Json& item : json.at(list)) {
      if (!item.is_object() || !item.contains("uri") || !item.at("uri").is_string()) continue;
      const auto uri = item.at("uri").get<std::string>();
      if (uri.starts_with("data:") || names.size() >= kMaxGltfResources) continue;
      VAMP_TRY(std::string name, percent_decoded(uri, path.string(), list));
      names.push_back(std::move(name));
    }
  }
  return names;
}

bool same_content(const fs::path& a, const fs::path& b) {
  const auto one = file_checksum(a), other = file_checksum(b);
  return one && other && *one == *other;
}

// A name in `folder` that is free or already holds the same content: "shoe.glb", "shoe 2.glb", ...
fs::path place_for(const fs::path& source, const fs::path& folder) {
  std::error_code code;
  for (int i = 1;; ++i) {
    const std::string number = i == 1 ? "" : " " + std::to_string(i);
    fs::path place = folder / (source.stem().string() + number + source.extension().string());
    if (!fs::exists(place, code) || same_content(place, source)) return place;
  }
}

Status copy_one(const fs::path& from, const fs::path& to) {
  std::error_code code;
  fs::create_directories(to.parent_path(), code);
  if (code) return cannot_copy(from, to, code.message());
  if (fs::is_directory(from, code)) {
    fs::copy(from, to, fs::copy_options::recursive | fs::copy_options::skip_symlinks, code);
    if (code) return cannot_copy(from, to, code.message());
    return {};
  }
  VAMP_TRY(const auto bytes, read_file(from, uint64_t{4} << 30));
  return write_file_atomically(to, bytes);
}

// Copies one file with what it needs; returns the copy.
Result<fs::path> collect(const fs::path& source, const fs::path& folder) {
  fs::path place = place_for(source, folder);
  std::vector<std::string> resources;
  if (source.extension() == ".gltf") {
    VAMP_TRY(resources, gltf_resources(source));
  }
  if (!resources.empty()) {
    // A folder of its own, since the names of what it needs are fixed.
    fs::path own = folder / source.stem();
    std::error_code code;
    for (int i = 2; fs::exists(own, code) && !same_content(own / source.filename(), source); ++i)
      own = folder / (source.stem().string() + " " + std::to_string(i));
    place = own / source.filename();
    for (const std::string& name : resources) {
      VAMP_TRY(const fs::path from, resolve_inside(source.parent_path(), name, source.string(), "uri"));
      VAMP_CHECK_STATUS(copy_one(from, own / name));
    }
  }
  VAMP_CHECK_STATUS(copy_one(source, place));
  return place;
}

}  // namespace

std::vector<fs::path> outside_files(const Project& project, const fs::path& path) {
  std::set<std::string> references = {make_reference(project.model), project.environment.path};
  for (const MaterialInstance& material : project.materials) references.insert(material.preset);
  std::vector<fs::path> outside;
  for (const std::string& reference : references)
    if (lies_outside(reference, folder_of(path))) outside.emplace_back(reference);
  return outside;
}

Result<Project> collect_files(const Project& project, const fs::path& path) {
  Project collected = project;
  const fs::path folder = folder_of(path) / (path.stem().string() + "_files");
  for (const fs::path& source : outside_files(project, path)) {
    VAMP_TRY(const fs::path copy, collect(source, folder));
    const std::string old = source.string(), reference = make_reference(copy);
    if (make_reference(collected.model) == old) collected.model = copy;
    if (collected.environment.path == old) collected.environment.path = reference;
    for (MaterialInstance& material : collected.materials)
      if (material.preset == old) material.preset = reference;
  }
  return collected;
}

}  // namespace vamp
