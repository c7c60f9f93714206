#pragma once
// Lights and cameras in project files: lengths in mm, angles in degrees, colours linear Rec.709, power in W (of a
// directional light: W per square scene unit, as in light.h).
#include "engine/core/json.h"
#include "engine/scene/camera.h"
#include "engine/scene/light.h"

namespace vamp {

Json light_to_json(const Light& light, double mm_per_unit);
Light light_from_json(const JsonReader& reader, double mm_per_unit);

Json camera_to_json(const Camera& camera, double mm_per_unit);
Camera camera_from_json(const JsonReader& reader, double mm_per_unit);

}  // namespace vamp
