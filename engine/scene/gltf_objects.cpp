#include "engine/scene/gltf_objects.h"

#include <algorithm>

#include "engine/scene/gltf_file.h"

namespace vamp {

Result<tinygltf::Model> read_objects(const GltfFile& gltf) {
  Json objects = gltf.json;
  for (const char* key : {"buffers", "images", "animations", "skins"}) objects.erase(key);
  const std::string text = objects.dump();
  if (text.size() > UINT32_MAX) return fail(ErrorKind::bad_input, gltf.file, "", "JSON below 4 GiB", "more");
  tinygltf::TinyGLTF reader;
  tinygltf::FsCallbacks nothing{};
  nothing.FileExists = [](const std::string&, void*) { return false; };
  nothing.ExpandFilePath = [](const std::string&, void*) { return std::string(); };
  nothing.ReadWholeFile = [](std::vector<unsigned char>*, std::string*, const std::string&, void*) { return false; };
  nothing.WriteWholeFile = [](std::string*, const std::string&, const std::vector<unsigned char>&, void*) {
    return false;
  };
  reader.SetFsCallbacks(nothing);
  reader.SetImageLoader([](tinygltf::Image*, const int, std::string*, std::string*, int, int, const unsigned char*, int,
                           void*) { return false; },
                        nullptr);
  tinygltf::Model model;
  std::string error;
  std::string warning;
  if (!reader.LoadASCIIFromString(&model, &error, &warning, text.data(), static_cast<unsigned int>(text.size()), "")) {
    std::replace(error.begin(), error.end(), '\n', ' ');
    return fail(ErrorKind::bad_input, gltf.file, "", "valid glTF", error.empty() ? "tinygltf refuses it" : error);
  }
  return model;
}

}  // namespace vamp
