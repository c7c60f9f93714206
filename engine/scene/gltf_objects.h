#pragma once
// The objects of a checked glTF through tinygltf.
#include <tiny_gltf.h>

#include "engine/core/error.h"

namespace vamp {

struct GltfFile;

// tinygltf reads the objects of the JSON; buffers and images were read before and are kept from it, so that it neither
// opens files nor decodes anything.
Result<tinygltf::Model> read_objects(const GltfFile& gltf);

}  // namespace vamp
