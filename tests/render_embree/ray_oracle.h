#pragma once
// The kernels' surface points and shadow rays once more, written apart from them and in double: what their text in
// shaders/lib/surface.glsl and shaders/lib/lights.glsl means. Only the random numbers and the light's axes are shared.
#include "engine/scene/light.h"
#include "engine/scene/scene.h"

namespace vamp {

struct OraclePoint {
  dvec3 position{0};
  dvec3 face{0};    // geometric normal, on the viewer's side
  dvec3 normal{0};  // shading normal, on the viewer's side, bent where he would not see it
  dvec3 start{0};   // where rays leave: off the surface by the rounding of the position
};

// Where the ray meets the triangle's plane.
OraclePoint oracle_point(const Scene& scene, int triangle, vec3 origin, vec3 direction);

struct OracleRay {
  dvec3 direction{0, 0, 1};
  double distance = 0;
  bool carries = false;  // false: below the surface or behind the light; no ray is traced
};

// Cosine-weighted about the shading normal; carries where it is above the face.
OracleRay oracle_occlusion_ray(const OraclePoint& point, vec2 u, double radius);

// To a rectangle or sphere light; carries where it is above the face and above the shading normal's horizon.
OracleRay oracle_light_ray(const OraclePoint& point, const Light& light, vec2 u);

}  // namespace vamp
