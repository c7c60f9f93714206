#pragma once
// The neutral studio: a seamless sweep, a camera, two soft lights.
#include "tools/shoe/gltf.h"

namespace vamp::shoe {

// Adds the part "Studio floor", the camera node, the light nodes and the scene's ambient light.
//
// glTF has no area lights, so a light is a node with `extras.vamp_light`:
//   {"type": "rect", "width": metres, "height": metres, "power": W, "color": [r, g, b] linear, "name": text}
// It emits from one side along the node's local -Z, Lambertian; width lies along local x, height along local y.
// The scene's `extras.vamp_ambient` is a constant ambient radiance [r, g, b], `extras.vamp_ao_radius` how far (in scene
// units) surfaces shade each other from it.
void add_studio(Scene& scene);

}  // namespace vamp::shoe
