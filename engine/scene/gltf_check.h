#pragma once
// Everything that glTF demands and that could hurt: ranges, sizes, indices, graphs. Run before any other code looks.
#include "engine/core/error.h"

namespace vamp {

struct GltfFile;

// After this every index of buffers, views, accessors, meshes, nodes, materials, textures, samplers and images points
// at something of the right kind, every accessor lies inside its bytes, and the nodes are a forest at most 256 deep.
Status check_gltf(const GltfFile& gltf);

}  // namespace vamp
