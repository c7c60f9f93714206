#include "engine/scene/gltf_objects.h"

#include <algorithm>
#include <glm/gtc/quaternion.hpp>
#include <glm/gtc/type_ptr.hpp>

#include "engine/scene/gltf_file.h"

namespace vamp {

Result<tinygltf::Model> read_objects(const GltfFile& gltf) {
  Json objects = Json::object();
  for (const auto& item : gltf.json.items())
    if (item.key() != "buffers" && item.key() != "images" && item.key() != "animations" && item.key() != "skins")
      objects[item.key()] = item.value();
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

glm::dmat4 local_matrix(const tinygltf::Node& node) {
  if (node.matrix.size() == 16) return glm::make_mat4(node.matrix.data());
  glm::dmat4 m(1.0);
  if (node.rotation.size() == 4) {
    const glm::dquat q(node.rotation[3], node.rotation[0], node.rotation[1], node.rotation[2]);
    if (glm::length(q) > 1e-9) m = glm::mat4_cast(glm::normalize(q));
  }
  if (node.scale.size() == 3)
    for (int k = 0; k < 3; ++k) m[k] *= node.scale[static_cast<size_t>(k)];
  if (node.translation.size() == 3)
    m[3] = glm::dvec4(node.translation[0], node.translation[1], node.translation[2], 1.0);
  return m;
}

std::vector<uvec3> triangles_of(const std::vector<uint32_t>& indices, int mode) {
  std::vector<uvec3> triangles;
  const size_t n = indices.size();
  if (mode == TINYGLTF_MODE_TRIANGLES) {
    triangles.reserve(n / 3);
    for (size_t i = 0; i + 2 < n; i += 3) triangles.emplace_back(indices[i], indices[i + 1], indices[i + 2]);
  } else {
    for (size_t i = 0; i + 2 < n; ++i) {
      if (mode == TINYGLTF_MODE_TRIANGLE_FAN)
        triangles.emplace_back(indices[0], indices[i + 1], indices[i + 2]);
      else
        triangles.emplace_back(indices[i], indices[i + 1 + i % 2], indices[i + 2 - i % 2]);
    }
  }
  return triangles;
}

}  // namespace vamp
