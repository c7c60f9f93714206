#pragma once
// Small glTF models made by hand, for tests: boxes, spheres and planes under chosen materials, or anything through
// json().
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/core/files.h"
#include "engine/core/json.h"
#include "engine/core/vec.h"

namespace vamp::test {

// What is empty is left out of the file. mode: glTF's, 4 triangles, 5 strip, 6 fan.
struct Shape {
  std::vector<vec3> positions;
  std::vector<vec3> normals;
  std::vector<vec4> tangents;
  std::vector<vec2> uvs;
  std::vector<uint32_t> indices;
  int mode = 4;
};

// Axis-aligned, centred, every face with UVs from 0 to 1, upright and unmirrored; outward normals.
Shape box(const vec3& size);
// Around the origin; u once around, v from 0 at +Y to 1 at -Y; smooth normals.
Shape sphere(float radius, uint32_t rings = 16);
// In the XZ plane, normal +Y, width along X, depth along Z, u along +X, v along +Z; `cells` x `cells` quads.
Shape plane(float width, float depth, uint32_t cells = 1);

class GlbBuilder {
 public:
  GlbBuilder();

  // Returns the index. An empty name is left out.
  int material(const std::string& name, const vec4& base_color = vec4(1), float metallic = 0, float roughness = 1);
  // A mesh with one primitive; material < 0: none.
  int mesh(const Shape& shape, int material = -1);
  // A root node with a mesh.
  int node(int mesh, const vec3& translation = vec3(0));
  // Any root node.
  int node(Json node);
  // mesh() and node() in one.
  int add(const Shape& shape, int material = -1, const vec3& translation = vec3(0));

  // Puts bytes into the buffer (aligned to 4) and returns the buffer view.
  int view(std::span<const std::byte> bytes, int stride = 0);
  // An accessor over a view.
  int accessor(int view, int component_type, size_t count, const std::string& type, bool normalized = false);
  template <class T>
  int accessor_of(const std::vector<T>& values, int component_type, const std::string& type, bool normalized = false) {
    return accessor(view(std::as_bytes(std::span(values))), component_type, values.size(), type, normalized);
  }

  Json& json() { return json_; }
  std::vector<std::byte>& buffer() { return buffer_; }

  // The .glb, or the .gltf with its buffer as a data: URI.
  std::vector<std::byte> glb() const;
  std::string gltf() const;
  // CHECKs that writing works.
  void write(const fs::path& path) const;

 private:
  Json json_;
  std::vector<std::byte> buffer_;
};

// A GLB from any text and any bytes, right or wrong.
std::vector<std::byte> pack_glb(const std::string& json, std::span<const std::byte> binary);
std::string base64(std::span<const std::byte> bytes);

}  // namespace vamp::test
