#include "tools/shoe/gltf.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "engine/core/check.h"

namespace vamp::shoe {
namespace {

constexpr int kFloat = 5126, kUint16 = 5123, kUint32 = 5125;
constexpr int kArrayBuffer = 34962, kElementBuffer = 34963;

// Adding zero makes -0 one with 0.
float rounded(double value, double step) { return static_cast<float>(std::round(value / step) * step + 0.0); }

class Writer {
 public:
  // Appends an accessor; returns its index.
  template <class T>
  size_t accessor(const std::vector<T>& values, size_t components, const char* type, int component_type, int target) {
    while (bytes_.size() % 4 != 0) bytes_.push_back(std::byte{0});
    const size_t offset = bytes_.size();
    bytes_.resize(offset + values.size() * sizeof(T));
    std::memcpy(bytes_.data() + offset, values.data(), values.size() * sizeof(T));
    views_.push_back(
        {{"buffer", 0}, {"byteOffset", offset}, {"byteLength", values.size() * sizeof(T)}, {"target", target}});
    accessors_.push_back({{"bufferView", views_.size() - 1},
                          {"componentType", component_type},
                          {"count", values.size() / components},
                          {"type", type}});
    return accessors_.size() - 1;
  }

  size_t positions(const std::vector<Vec3>& mm) {
    std::vector<float> values;
    Json low = Json::array(), high = Json::array();
    for (const Vec3& p : mm) {
      for (int axis = 0; axis < 3; ++axis) values.push_back(rounded(p[axis] / kMmPerUnit, 1e-6));
    }
    for (size_t axis = 0; axis < 3; ++axis) {
      float least = values[axis], most = values[axis];
      for (size_t i = axis; i < values.size(); i += 3) {
        least = std::min(least, values[i]);
        most = std::max(most, values[i]);
      }
      low.push_back(least);
      high.push_back(most);
    }
    const size_t index = accessor(values, 3, "VEC3", kFloat, kArrayBuffer);
    accessors_[index]["min"] = low;
    accessors_[index]["max"] = high;
    return index;
  }

  Json primitive(const Mesh& mesh, size_t material) {
    std::vector<float> normals, uvs;
    for (const Vec3& n : mesh.normals) {
      // Rounded, then made unit again: both steps give the same float for neighbouring doubles.
      const Vec3 unit = glm::normalize(glm::round(n * 1e4) / 1e4);
      for (int axis = 0; axis < 3; ++axis) normals.push_back(static_cast<float>(unit[axis] + 0.0));
    }
    for (const Vec2& uv : mesh.uvs) {
      for (int axis = 0; axis < 2; ++axis) uvs.push_back(rounded(uv[axis] / kMmPerUv, 1e-5));
    }
    const size_t position = positions(mesh.positions);
    const size_t normal = accessor(normals, 3, "VEC3", kFloat, kArrayBuffer);
    const size_t uv = accessor(uvs, 2, "VEC2", kFloat, kArrayBuffer);
    size_t index = 0;
    if (mesh.positions.size() < 65535) {
      const std::vector<uint16_t> small(mesh.indices.begin(), mesh.indices.end());
      index = accessor(small, 1, "SCALAR", kUint16, kElementBuffer);
    } else {
      index = accessor(mesh.indices, 1, "SCALAR", kUint32, kElementBuffer);
    }
    return {{"attributes", {{"POSITION", position}, {"NORMAL", normal}, {"TEXCOORD_0", uv}}},
            {"indices", index},
            {"material", material}};
  }

  Json views_ = Json::array(), accessors_ = Json::array();
  std::vector<std::byte> bytes_;
};

void append_u32(std::vector<std::byte>& out, size_t value) {
  for (int shift = 0; shift < 32; shift += 8) out.push_back(static_cast<std::byte>((value >> shift) & 0xff));
}

void append_chunk(std::vector<std::byte>& out, uint32_t type, std::vector<std::byte> data, std::byte padding) {
  while (data.size() % 4 != 0) data.push_back(padding);
  append_u32(out, data.size());
  append_u32(out, type);
  out.insert(out.end(), data.begin(), data.end());
}

}  // namespace

std::vector<std::byte> to_glb(const Scene& scene) {
  Writer writer;
  Json materials = Json::array(), meshes = Json::array(), nodes = Json::array(), roots = Json::array();
  for (const Part& part : scene.parts) {
    CHECK(part.mesh.normals.size() == part.mesh.positions.size() && part.mesh.uvs.size() == part.mesh.positions.size());
    materials.push_back({{"name", part.name},
                         {"pbrMetallicRoughness",
                          {{"baseColorFactor", {part.colour.x, part.colour.y, part.colour.z, 1.0}},
                           {"metallicFactor", part.metallic},
                           {"roughnessFactor", part.roughness}}}});
    meshes.push_back(
        {{"name", part.name}, {"primitives", Json::array({writer.primitive(part.mesh, materials.size() - 1)})}});
    nodes.push_back({{"name", part.name}, {"mesh", meshes.size() - 1}});
  }
  for (const Json& node : scene.nodes) nodes.push_back(node);
  for (size_t i = 0; i < nodes.size(); ++i) roots.push_back(i);

  Json root;
  root["asset"] = {{"version", "2.0"}, {"generator", "Vamp make_shoe"}};
  root["scene"] = 0;
  root["scenes"] = Json::array({{{"name", "Derby"}, {"nodes", roots}, {"extras", scene.extras}}});
  root["nodes"] = nodes;
  root["cameras"] = scene.cameras;
  root["meshes"] = meshes;
  root["materials"] = materials;
  root["accessors"] = writer.accessors_;
  root["bufferViews"] = writer.views_;
  while (writer.bytes_.size() % 4 != 0) writer.bytes_.push_back(std::byte{0});
  root["buffers"] = Json::array({{{"byteLength", writer.bytes_.size()}}});

  const std::string text = root.dump();
  std::vector<std::byte> json(text.size());
  std::memcpy(json.data(), text.data(), text.size());
  std::vector<std::byte> chunks;
  append_chunk(chunks, 0x4E4F534A, std::move(json), std::byte{' '});
  append_chunk(chunks, 0x004E4942, std::move(writer.bytes_), std::byte{0});
  std::vector<std::byte> file;
  append_u32(file, 0x46546C67);
  append_u32(file, 2);
  append_u32(file, 12 + chunks.size());
  file.insert(file.end(), chunks.begin(), chunks.end());
  return file;
}

}  // namespace vamp::shoe
