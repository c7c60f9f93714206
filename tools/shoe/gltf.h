#pragma once
// Writing a scene as GLB, the same bytes for the same scene.
#include "engine/core/files.h"
#include "engine/core/json.h"
#include "tools/shoe/mesh.h"

namespace vamp::shoe {

// UVs are mm in the meshes and mm / kMmPerUv in the file: one scale for u, v and all parts, never mirrored.
constexpr double kMmPerUv = 100.0;
constexpr double kMmPerUnit = 1000.0;

struct Scene {
  std::vector<Part> parts;
  std::vector<Json> nodes;  // cameras and lights, after the parts' nodes
  std::vector<Json> cameras;
  Json extras;  // of the scene
};

// Positions are rounded to 1 micrometre, UVs to 1e-5 and normals to 1e-4 before they are stored, so that the last bits
// of a machine's sine do not show in the file.
std::vector<std::byte> to_glb(const Scene& scene);

}  // namespace vamp::shoe
