#include "engine/scene/camera.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>
#include <limits>

namespace vamp {
namespace {

constexpr float kMinFov = 1.0f;
constexpr float kMaxFov = 170.0f;
constexpr float kPoleDegrees = 1.0f;  // how near the view may come to `up` while orbiting

vec3 unit_or(const vec3& v, const vec3& otherwise) {
  const float length = glm::length(v);
  return length > 0 && std::isfinite(length) ? v / length : otherwise;
}

vec3 view_direction(const Camera& camera) { return unit_or(camera.target - camera.eye, vec3(0, 0, -1)); }

float half_fov(const Camera& camera) { return glm::radians(std::clamp(camera.fov_degrees, kMinFov, kMaxFov)) * 0.5f; }

// `v` turned about the unit vector `axis` (Rodrigues).
vec3 turn(const vec3& v, const vec3& axis, float radians) {
  const float c = std::cos(radians);
  return v * c + glm::cross(axis, v) * std::sin(radians) + axis * (glm::dot(axis, v) * (1 - c));
}

vec3 right_of(const vec3& forward, const vec3& up) {
  const vec3 right = glm::cross(forward, unit_or(up, vec3(0, 1, 0)));
  if (glm::length(right) > 1e-5f) return glm::normalize(right);
  const vec3 other = std::abs(forward.z) < 0.9f ? vec3(0, 0, -1) : vec3(0, 1, 0);
  return glm::normalize(glm::cross(forward, other));
}

}  // namespace

float Bounds::radius() const { return empty() ? 0.0f : glm::length(hi * 0.5f - lo * 0.5f); }

CameraFrame camera_frame(const Camera& camera, float aspect) {
  const vec3 forward = view_direction(camera);
  const vec3 right = right_of(forward, camera.up);
  const float tangent = std::tan(half_fov(camera));
  return {camera.eye, right * (tangent * aspect), glm::cross(right, forward) * tangent, forward};
}

vec3 camera_ray(const CameraFrame& frame, float x, float y) {
  return glm::normalize(frame.forward + x * frame.right + y * frame.up);
}

Camera orbit(const Camera& camera, float yaw_degrees, float pitch_degrees) {
  const vec3 up = unit_or(camera.up, vec3(0, 1, 0));
  const float distance = glm::length(camera.target - camera.eye);
  vec3 back = turn(-view_direction(camera), up, glm::radians(yaw_degrees));
  const float elevation = glm::degrees(std::asin(std::clamp(glm::dot(back, up), -1.0f, 1.0f)));
  const float limit = 90.0f - kPoleDegrees;
  const float wanted = std::clamp(elevation + pitch_degrees, -limit, limit);
  back = turn(back, right_of(-back, up), glm::radians(elevation - wanted));
  Camera turned = camera;
  turned.eye = camera.target + back * distance;
  return turned;
}

Camera pan(const Camera& camera, float x, float y) {
  const CameraFrame frame = camera_frame(camera, 1.0f);
  const float height = 2.0f * glm::length(camera.target - camera.eye);
  const vec3 step = (frame.right * x + frame.up * y) * height;
  Camera moved = camera;
  moved.eye += step;
  moved.target += step;
  return moved;
}

Camera dolly(const Camera& camera, float factor, float scene_radius) {
  const float distance = glm::length(camera.target - camera.eye);
  const float wanted = std::clamp(distance * factor, 1e-4f * scene_radius, 1e4f * scene_radius);
  Camera moved = camera;
  if (std::isfinite(wanted)) moved.eye = camera.target - view_direction(camera) * wanted;
  return moved;
}

Camera fit(const Camera& camera, const Bounds& bounds, float aspect) {
  if (bounds.empty()) return camera;
  // The sphere touches the edges of the narrower angle of view.
  const float half_vertical = half_fov(camera);
  const float half_horizontal = std::atan(std::tan(half_vertical) * aspect);
  const float radius = std::max(bounds.radius(), 1e-6f);
  Camera fitted = camera;
  fitted.target = bounds.center();
  fitted.eye = fitted.target - view_direction(camera) * (radius / std::sin(std::min(half_vertical, half_horizontal)));
  return fitted;
}

Camera fit(const Camera& camera, std::span<const vec3> points, float aspect, float margin) {
  Bounds bounds;
  for (const vec3& p : points) bounds.extend(p);
  if (bounds.empty() || !(bounds.radius() > 0)) return camera;
  const CameraFrame frame = camera_frame(camera, aspect);
  const vec3 sides[2] = {glm::normalize(frame.right), glm::normalize(frame.up)};
  const vec3 tangents[2] = {frame.right, frame.up};

  // Along one side s of the picture with t = tan(half angle), less the margin: |s.p - s.eye| <= t (f.p - f.eye). The
  // points of either edge that press most say where the eye may stand at the nearest, and the middle between them.
  float depth = std::numeric_limits<float>::max();
  vec3 middle(0);
  for (int axis = 0; axis < 2; ++axis) {
    const float t = glm::length(tangents[axis]) * (1 - 2 * margin);
    float low = -std::numeric_limits<float>::max(), high = low;
    for (const vec3& p : points) {
      const vec3 from = p - bounds.center();
      const float along = glm::dot(from, sides[axis]), back = t * glm::dot(from, frame.forward);
      high = std::max(high, along - back);
      low = std::max(low, -along - back);
    }
    depth = std::min(depth, -(high + low) / (2 * t));
    middle += sides[axis] * ((high - low) / 2);
  }
  Camera fitted = camera;
  fitted.target = bounds.center() + middle;
  fitted.eye = fitted.target + frame.forward * depth;
  return fitted;
}

bool in_view(const Camera& camera, std::span<const vec3> points, float aspect, float margin) {
  const CameraFrame frame = camera_frame(camera, aspect);
  const vec3 right = frame.right / glm::dot(frame.right, frame.right), up = frame.up / glm::dot(frame.up, frame.up);
  return std::all_of(points.begin(), points.end(), [&](const vec3& p) {
    const vec3 from = p - frame.origin;
    const float edge = (1 - 2 * margin) * glm::dot(from, frame.forward);
    return std::abs(glm::dot(from, right)) <= edge && std::abs(glm::dot(from, up)) <= edge;
  });
}

Camera default_camera(const Bounds& bounds, float aspect) {
  Camera camera;
  camera.name = "Default";
  camera.eye = vec3(1.0f, 0.6f, 1.2f);
  camera.target = vec3(0);
  return fit(camera, bounds, aspect);
}

}  // namespace vamp
