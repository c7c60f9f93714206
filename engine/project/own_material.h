#pragma once
// A part's own glTF material as a material instance.
#include "engine/project/project.h"

namespace vamp {

// Base colour with its texture; metallic and roughness at their textures' means. Where the texture lies is the scene's
// to say: the renderer takes its transform from the part.
MaterialInstance own_material(const Scene& scene, int part);

}  // namespace vamp
