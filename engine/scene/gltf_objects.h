#pragma once
// The objects of a checked glTF through tinygltf.
#include <tiny_gltf.h>

#include <glm/mat4x4.hpp>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/vec.h"

namespace vamp {

struct GltfFile;

// tinygltf reads the objects of the JSON; buffers and images were read before and are kept from it, so that it neither
// opens files nor decodes anything.
Result<tinygltf::Model> read_objects(const GltfFile& gltf);

// The node's own transform: its matrix, or translation * rotation * scale.
glm::dmat4 local_matrix(const tinygltf::Node& node);

// Lists, strips and fans as separate triangles, in the winding that glTF 2.0, section 3.7.2.1 gives them.
std::vector<uvec3> triangles_of(const std::vector<uint32_t>& indices, int mode);

}  // namespace vamp
