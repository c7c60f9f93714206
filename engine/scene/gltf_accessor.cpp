#include "engine/scene/gltf_accessor.h"

#include <fmt/format.h>
#include <tiny_gltf.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace vamp {
namespace {

template <class T>
T load(const std::byte* at) {
  T value;
  std::memcpy(&value, at, sizeof(T));
  return value;
}

// glTF 2.0, section 3.6.2.2: c / max for unsigned, max(c / max, -1) for signed.
float component(const std::byte* at, int type, bool normalized) {
  switch (type) {
    case TINYGLTF_COMPONENT_TYPE_BYTE: {
      const float c = load<int8_t>(at);
      return normalized ? std::max(c / 127.0f, -1.0f) : c;
    }
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: {
      const float c = load<uint8_t>(at);
      return normalized ? c / 255.0f : c;
    }
    case TINYGLTF_COMPONENT_TYPE_SHORT: {
      const float c = load<int16_t>(at);
      return normalized ? std::max(c / 32767.0f, -1.0f) : c;
    }
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: {
      const float c = load<uint16_t>(at);
      return normalized ? c / 65535.0f : c;
    }
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
      return static_cast<float>(load<uint32_t>(at));
    default:
      return load<float>(at);
  }
}

uint32_t index_value(const std::byte* at, int type) {
  if (type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE) return load<uint8_t>(at);
  if (type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT) return load<uint16_t>(at);
  return load<uint32_t>(at);
}

size_t bytes_of(int type) {
  return static_cast<size_t>(tinygltf::GetComponentSizeInBytes(static_cast<uint32_t>(type)));
}

// A run of equal elements in a buffer; data is null for zeros.
struct Run {
  const std::byte* data = nullptr;
  size_t stride = 0;
  const std::byte* at(size_t i) const { return data + i * stride; }
};

Run run_of(const GltfSource& gltf, int view_number, size_t offset, size_t element_bytes, bool may_stride) {
  if (view_number < 0) return {};
  const tinygltf::BufferView& view = gltf.model.bufferViews[static_cast<size_t>(view_number)];
  const size_t stride = may_stride && view.byteStride > 0 ? view.byteStride : element_bytes;
  return {gltf.buffers[static_cast<size_t>(view.buffer)].data() + view.byteOffset + offset, stride};
}

// Replaces what a sparse accessor replaces: put(element, bytes).
template <class Put>
Status apply_sparse(const GltfSource& gltf, int number, const tinygltf::Accessor& accessor, size_t element_bytes,
                    Put put) {
  if (!accessor.sparse.isSparse) return {};
  const auto& sparse = accessor.sparse;
  const Run places = run_of(gltf, sparse.indices.bufferView, static_cast<size_t>(sparse.indices.byteOffset),
                            bytes_of(sparse.indices.componentType), false);
  const Run values =
      run_of(gltf, sparse.values.bufferView, static_cast<size_t>(sparse.values.byteOffset), element_bytes, false);
  int64_t previous = -1;
  for (size_t i = 0; i < static_cast<size_t>(sparse.count); ++i) {
    const uint32_t place = index_value(places.at(i), sparse.indices.componentType);
    if (place >= accessor.count || place <= previous)
      return fail(ErrorKind::bad_input, gltf.file, fmt::format("accessors[{}].sparse.indices", number),
                  fmt::format("rising indices below {}", accessor.count), std::to_string(place));
    previous = place;
    put(place, values.at(i));
  }
  return {};
}

template <class V>
Result<std::vector<V>> read_vectors(const GltfSource& gltf, int number) {
  const tinygltf::Accessor& accessor = gltf.model.accessors[static_cast<size_t>(number)];
  constexpr int kLength = V::length();
  const size_t size = bytes_of(accessor.componentType);
  const size_t element_bytes = size * static_cast<size_t>(kLength);
  std::vector<V> values(accessor.count, V(0.0f));
  const auto put = [&](size_t i, const std::byte* at) {
    for (int k = 0; k < kLength; ++k)
      values[i][k] = component(at + static_cast<size_t>(k) * size, accessor.componentType, accessor.normalized);
  };
  const Run run = run_of(gltf, accessor.bufferView, accessor.byteOffset, element_bytes, true);
  if (run.data != nullptr)
    for (size_t i = 0; i < accessor.count; ++i) put(i, run.at(i));
  VAMP_CHECK_STATUS(apply_sparse(gltf, number, accessor, element_bytes, put));
  for (size_t i = 0; i < values.size(); ++i)
    for (int k = 0; k < kLength; ++k)
      if (!std::isfinite(values[i][k]))
        return fail(ErrorKind::bad_input, gltf.file, fmt::format("accessors[{}], element {}", number, i),
                    "finite numbers", fmt::format("{}", values[i][k]));
  return values;
}

}  // namespace

Result<std::vector<vec2>> read_vec2(const GltfSource& gltf, int accessor) { return read_vectors<vec2>(gltf, accessor); }
Result<std::vector<vec3>> read_vec3(const GltfSource& gltf, int accessor) { return read_vectors<vec3>(gltf, accessor); }
Result<std::vector<vec4>> read_vec4(const GltfSource& gltf, int accessor) { return read_vectors<vec4>(gltf, accessor); }

size_t accessor_count(const GltfSource& gltf, int accessor) {
  return gltf.model.accessors[static_cast<size_t>(accessor)].count;
}

Result<std::vector<uint32_t>> read_indices(const GltfSource& gltf, int number, uint32_t vertex_count) {
  const tinygltf::Accessor& accessor = gltf.model.accessors[static_cast<size_t>(number)];
  const size_t size = bytes_of(accessor.componentType);
  std::vector<uint32_t> values(accessor.count, 0);
  const auto put = [&](size_t i, const std::byte* at) { values[i] = index_value(at, accessor.componentType); };
  const Run run = run_of(gltf, accessor.bufferView, accessor.byteOffset, size, true);
  if (run.data != nullptr)
    for (size_t i = 0; i < accessor.count; ++i) put(i, run.at(i));
  VAMP_CHECK_STATUS(apply_sparse(gltf, number, accessor, size, put));
  for (size_t i = 0; i < values.size(); ++i)
    if (values[i] >= vertex_count)
      return fail(ErrorKind::bad_input, gltf.file, fmt::format("accessors[{}], element {}", number, i),
                  fmt::format("an index below {}", vertex_count), std::to_string(values[i]));
  return values;
}

}  // namespace vamp
