#pragma once
// Where the picture is taken from. Lengths in scene units, right-handed, angles in degrees.
#include <span>
#include <string>

#include "engine/core/error.h"
#include "engine/core/vec.h"
#include "engine/scene/bounds.h"

namespace vamp {

struct Camera {
  std::string name;
  vec3 eye{0, 0, 1};
  vec3 target{0, 0, 0};
  vec3 up{0, 1, 0};
  float fov_degrees = 35;  // vertical, 1 to 170

  bool operator==(const Camera&) const = default;
};

// What the primary ray needs. The ray through x, y in [-1, 1] (x to the right, y up) is
//   origin, normalize(forward + x * right + y * up);
// forward is a unit vector, right and up carry tan(fov / 2) and the aspect ratio. For sample position (px, py) in
// pixels with row 0 at the top: x = 2 px / width - 1, y = 1 - 2 py / height.
struct CameraFrame {
  vec3 origin{0};
  vec3 right{1, 0, 0};
  vec3 up{0, 1, 0};
  vec3 forward{0, 0, -1};
};

// aspect = width / height. Any camera gives a frame: where eye and target coincide it looks along -Z, where `up` is
// parallel to the view another axis takes its place.
CameraFrame camera_frame(const Camera& camera, float aspect);

// The direction (unit) through x, y in [-1, 1]; the same arithmetic as the shader's.
vec3 camera_ray(const CameraFrame& frame, float x, float y);

// Turns about the target: yaw about `up`, pitch towards it, both in degrees. Stops 1 degree before the poles.
Camera orbit(const Camera& camera, float yaw_degrees, float pitch_degrees);

// Moves eye and target sideways, in fractions of the picture's height at the target (drag by dx / height, dy / height;
// positive x moves the camera to the right, positive y upwards).
Camera pan(const Camera& camera, float x, float y);

// Scales the distance to the target; factors below 1 go closer. Stays between 1e-4 and 1e4 times `scene_radius`.
Camera dolly(const Camera& camera, float factor, float scene_radius = 1.0f);

// Keeps the direction of view and moves so that the bounding sphere of `bounds` just fits in width / height = aspect.
// Empty bounds leave the camera as it is.
Camera fit(const Camera& camera, const Bounds& bounds, float aspect);

// The same for points, closer: they just fit, in the middle, and `margin` of the picture stays free on each side (0 to
// 0.4, a fraction of its width and height). No points, or points in one place, leave the camera as it is.
Camera fit(const Camera& camera, std::span<const vec3> points, float aspect, float margin);

// Whether all points are in the picture and none nearer to its edge than `margin`.
bool in_view(const Camera& camera, std::span<const vec3> points, float aspect, float margin);

// The three-quarter view that a model without a camera is shown in.
Camera default_camera(const Bounds& bounds, float aspect);

}  // namespace vamp
