#pragma once
// The default scene: a derby in a studio.
#include "tools/shoe/gltf.h"

namespace vamp::shoe {

// Every part has UVs in mm (kMmPerUv a unit), u along its grain: with the shoe's length, for bands and tubes along
// them, for the heel counter around the heel.
Scene make_shoe_scene();

}  // namespace vamp::shoe
