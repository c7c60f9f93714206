#pragma once
// Materials, textures, cameras and lights of a checked glTF as the scene knows them.
#include <functional>
#include <glm/mat4x4.hpp>

#include "engine/core/json.h"
#include "engine/scene/scene.h"

namespace tinygltf {
class Model;
}

namespace vamp {

struct GltfFile;

using Say = std::function<void(std::string)>;  // a note for the log and the scene

// One for each of the file's materials. Texture slots point into scene.textures, which receives each used image once
// for each colour space; pictures with a side over 2048 are averaged down.
Result<std::vector<SurfaceMaterial>> read_materials(const GltfFile& gltf, const tinygltf::Model& model, Scene& scene,
                                                    const Say& say);

// The camera of a node, or nothing when it is orthographic.
std::optional<Camera> read_camera(const tinygltf::Model& model, int camera, const glm::dmat4& world_from_node,
                                  const Bounds& bounds);

// A light of KHR_lights_punctual.
Light read_punctual_light(const tinygltf::Model& model, int light, const glm::dmat4& world_from_node);

// extras.vamp_light of a node: {"type": "rect" | "disk" | "sphere" | "point", "width", "height", "radius", "power",
// "color": [r, g, b], "name"}, emitting along the node's -Z, the width along its X.
Result<Light> read_vamp_light(const JsonReader& extras, const glm::dmat4& world_from_node,
                              const std::string& node_name);

}  // namespace vamp
