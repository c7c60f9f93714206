#include "tests/scene/glb_builder.h"

#include <cmath>
#include <cstring>
#include <glm/geometric.hpp>
#include <numbers>

#include "engine/core/check.h"

namespace vamp::test {
namespace {

void append_word(std::vector<std::byte>& bytes, uint32_t word) {
  for (int shift = 0; shift < 32; shift += 8) bytes.push_back(static_cast<std::byte>(word >> shift & 0xffu));
}

int push(Json& array, Json value) {
  array.push_back(std::move(value));
  return static_cast<int>(array.size()) - 1;
}

Json numbers(const vec3& v) { return Json::array({v.x, v.y, v.z}); }

}  // namespace

Shape box(const vec3& size) {
  Shape s;
  const vec3 h = size * 0.5f;
  for (int axis = 0; axis < 3; ++axis)
    for (const float sign : {1.0f, -1.0f}) {
      vec3 n(0);
      n[axis] = sign;
      // As seen from outside: right and up so that right x up = n.
      const vec3 up = axis == 1 ? vec3(0, 0, -sign) : vec3(0, 1, 0);
      const vec3 right = glm::cross(up, n);
      const auto base = static_cast<uint32_t>(s.positions.size());
      for (const vec2 uv : {vec2(0, 1), vec2(1, 1), vec2(1, 0), vec2(0, 0)}) {
        s.positions.push_back(h * (n + right * (2 * uv.x - 1) + up * (1 - 2 * uv.y)));
        s.normals.push_back(n);
        s.uvs.push_back(uv);
      }
      for (const uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) s.indices.push_back(base + i);
    }
  return s;
}

Shape sphere(float radius, uint32_t rings) {
  Shape s;
  const uint32_t columns = 2 * rings;
  for (uint32_t j = 0; j <= rings; ++j)
    for (uint32_t i = 0; i <= columns; ++i) {
      const float u = static_cast<float>(i) / static_cast<float>(columns);
      const float v = static_cast<float>(j) / static_cast<float>(rings);
      const float theta = v * std::numbers::pi_v<float>;
      const float phi = u * 2 * std::numbers::pi_v<float>;
      const vec3 n(std::sin(theta) * std::sin(phi), std::cos(theta), std::sin(theta) * std::cos(phi));
      s.positions.push_back(n * radius);
      s.normals.push_back(n);
      s.uvs.emplace_back(u, v);
    }
  for (uint32_t j = 0; j < rings; ++j)
    for (uint32_t i = 0; i < columns; ++i) {
      const uint32_t a = j * (columns + 1) + i;
      const uint32_t b = a + columns + 1;
      if (j > 0) s.indices.insert(s.indices.end(), {a, b, a + 1});
      if (j + 1 < rings) s.indices.insert(s.indices.end(), {a + 1, b, b + 1});
    }
  return s;
}

Shape plane(float width, float depth, uint32_t cells) {
  Shape s;
  for (uint32_t j = 0; j <= cells; ++j)
    for (uint32_t i = 0; i <= cells; ++i) {
      const vec2 uv(static_cast<float>(i) / static_cast<float>(cells),
                    static_cast<float>(j) / static_cast<float>(cells));
      s.positions.emplace_back((uv.x - 0.5f) * width, 0, (uv.y - 0.5f) * depth);
      s.normals.emplace_back(0, 1, 0);
      s.uvs.push_back(uv);
    }
  for (uint32_t j = 0; j < cells; ++j)
    for (uint32_t i = 0; i < cells; ++i) {
      const uint32_t a = j * (cells + 1) + i;
      const uint32_t b = a + cells + 1;
      s.indices.insert(s.indices.end(), {a, b, a + 1, a + 1, b, b + 1});
    }
  return s;
}

GlbBuilder::GlbBuilder() {
  json_["asset"]["version"] = "2.0";
  json_["scene"] = 0;
  json_["scenes"] = Json::array({Json{{"nodes", Json::array()}}});
}

int GlbBuilder::material(const std::string& name, const vec4& base_color, float metallic, float roughness) {
  Json m = Json::object();
  if (!name.empty()) m["name"] = name;
  m["pbrMetallicRoughness"] = {
      {"baseColorFactor", Json::array({base_color.x, base_color.y, base_color.z, base_color.w})},
      {"metallicFactor", metallic},
      {"roughnessFactor", roughness}};
  return push(json_["materials"], m);
}

int GlbBuilder::view(std::span<const std::byte> bytes, int stride) {
  while (buffer_.size() % 4 != 0) buffer_.push_back(std::byte{0});
  Json v = {{"buffer", 0}, {"byteOffset", buffer_.size()}, {"byteLength", bytes.size()}};
  if (stride > 0) v["byteStride"] = stride;
  buffer_.insert(buffer_.end(), bytes.begin(), bytes.end());
  return push(json_["bufferViews"], v);
}

int GlbBuilder::accessor(int view, int component_type, size_t count, const std::string& type, bool normalized) {
  Json a = {{"bufferView", view}, {"componentType", component_type}, {"count", count}, {"type", type}};
  if (normalized) a["normalized"] = true;
  return push(json_["accessors"], a);
}

int GlbBuilder::mesh(const Shape& shape, int material) {
  Json attributes = Json::object();
  if (!shape.positions.empty()) attributes["POSITION"] = accessor_of(shape.positions, 5126, "VEC3");
  if (!shape.normals.empty()) attributes["NORMAL"] = accessor_of(shape.normals, 5126, "VEC3");
  if (!shape.tangents.empty()) attributes["TANGENT"] = accessor_of(shape.tangents, 5126, "VEC4");
  if (!shape.uvs.empty()) attributes["TEXCOORD_0"] = accessor_of(shape.uvs, 5126, "VEC2");
  Json primitive = {{"attributes", attributes}};
  if (!shape.indices.empty()) primitive["indices"] = accessor_of(shape.indices, 5125, "SCALAR");
  if (material >= 0) primitive["material"] = material;
  if (shape.mode != 4) primitive["mode"] = shape.mode;
  return push(json_["meshes"], Json{{"primitives", Json::array({primitive})}});
}

int GlbBuilder::node(Json node) {
  const int index = push(json_["nodes"], std::move(node));
  json_["scenes"][0]["nodes"].push_back(index);
  return index;
}

int GlbBuilder::node(int mesh, const vec3& translation) {
  Json n = {{"mesh", mesh}};
  if (translation != vec3(0)) n["translation"] = numbers(translation);
  return node(std::move(n));
}

int GlbBuilder::add(const Shape& shape, int material, const vec3& translation) {
  return node(mesh(shape, material), translation);
}

std::vector<std::byte> GlbBuilder::glb() const {
  Json whole = json_;
  if (!buffer_.empty()) whole["buffers"] = Json::array({Json{{"byteLength", buffer_.size()}}});
  return pack_glb(whole.dump(), buffer_);
}

std::string GlbBuilder::gltf() const {
  Json whole = json_;
  if (!buffer_.empty())
    whole["buffers"] = Json::array(
        {Json{{"byteLength", buffer_.size()}, {"uri", "data:application/octet-stream;base64," + base64(buffer_)}}});
  return whole.dump();
}

void GlbBuilder::write(const fs::path& path) const {
  if (path.extension() == ".gltf")
    CHECK(write_text_atomically(path, gltf()).has_value());
  else
    CHECK(write_file_atomically(path, glb()).has_value());
}

std::vector<std::byte> pack_glb(const std::string& json, std::span<const std::byte> binary) {
  std::string text = json;
  while (text.size() % 4 != 0) text += ' ';
  const size_t padded = (binary.size() + 3) / 4 * 4;
  std::vector<std::byte> bytes;
  append_word(bytes, 0x46546c67);
  append_word(bytes, 2);
  append_word(bytes, static_cast<uint32_t>(12 + 8 + text.size() + (padded > 0 ? 8 + padded : 0)));
  append_word(bytes, static_cast<uint32_t>(text.size()));
  append_word(bytes, 0x4e4f534a);
  const auto text_bytes = std::as_bytes(std::span(text));
  bytes.insert(bytes.end(), text_bytes.begin(), text_bytes.end());
  if (padded == 0) return bytes;
  append_word(bytes, static_cast<uint32_t>(padded));
  append_word(bytes, 0x004e4942);
  bytes.insert(bytes.end(), binary.begin(), binary.end());
  bytes.resize(bytes.size() + padded - binary.size());
  return bytes;
}

std::string base64(std::span<const std::byte> bytes) {
  static constexpr char kDigits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (size_t i = 0; i < bytes.size(); i += 3) {
    uint32_t bits = 0;
    for (size_t k = 0; k < 3; ++k) bits = bits << 8 | (i + k < bytes.size() ? static_cast<uint32_t>(bytes[i + k]) : 0u);
    for (size_t k = 0; k < 4; ++k) text += i + k <= bytes.size() ? kDigits[bits >> (18 - 6 * k) & 63u] : '=';
  }
  return text;
}

}  // namespace vamp::test
