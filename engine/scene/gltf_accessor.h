#pragma once
// Numbers out of a checked glTF: any component type, stride, normalised integers, sparse accessors.
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/vec.h"

namespace tinygltf {
class Model;
}

namespace vamp {

struct GltfSource {
  const tinygltf::Model& model;
  const std::vector<std::span<const std::byte>>& buffers;
  const std::string& file;
};

// Elements of an accessor as floats, V::length() a piece. A value that is not finite is an error that names it.
Result<std::vector<vec2>> read_vec2(const GltfSource& gltf, int accessor);
Result<std::vector<vec3>> read_vec3(const GltfSource& gltf, int accessor);
Result<std::vector<vec4>> read_vec4(const GltfSource& gltf, int accessor);

// Indices, all below vertex_count.
Result<std::vector<uint32_t>> read_indices(const GltfSource& gltf, int accessor, uint32_t vertex_count);

// How many elements an accessor has.
size_t accessor_count(const GltfSource& gltf, int accessor);

}  // namespace vamp
