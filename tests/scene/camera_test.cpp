#include "engine/scene/camera.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace vamp {
namespace {

void expect_near(const vec3& a, const vec3& b, float tolerance) { EXPECT_LT(glm::length(a - b), tolerance); }

TEST(Camera, CornersOfThePictureLieAtTheFieldOfView) {
  Camera camera;
  camera.eye = vec3(0, 0, 5);
  camera.fov_degrees = 90;
  const CameraFrame frame = camera_frame(camera, 2.0f);
  expect_near(camera_ray(frame, 0, 0), vec3(0, 0, -1), 1e-6f);
  expect_near(camera_ray(frame, 0, 1), glm::normalize(vec3(0, 1, -1)), 1e-6f);
  expect_near(camera_ray(frame, 1, 0), glm::normalize(vec3(2, 0, -1)), 1e-6f);
}

TEST(Camera, DegenerateCamerasStillHaveAFrame) {
  Camera camera;
  camera.eye = camera.target = vec3(1, 2, 3);
  CameraFrame f = camera_frame(camera, 1);
  EXPECT_TRUE(std::isfinite(glm::length(f.right)) && glm::length(f.right) > 0);
  camera.eye = vec3(0, 5, 0);
  camera.target = vec3(0);
  f = camera_frame(camera, 1);
  EXPECT_TRUE(std::isfinite(glm::length(f.right)) && glm::length(f.right) > 0);
  EXPECT_NEAR(glm::dot(f.right, f.forward), 0, 1e-6f);
  camera.up = vec3(0);
  EXPECT_TRUE(std::isfinite(glm::length(camera_frame(camera, 1).up)));
}

TEST(Camera, OrbitKeepsTheDistanceAndReturns) {
  Camera camera;
  camera.eye = vec3(1, 1, 4);
  camera.target = vec3(0, 0.5f, 0);
  const Camera there = orbit(camera, 40, 20);
  EXPECT_NEAR(glm::length(there.eye - there.target), glm::length(camera.eye - camera.target), 1e-5f);
  EXPECT_GT(there.eye.y, camera.eye.y);
  expect_near(orbit(orbit(there, 0, -20), -40, 0).eye, camera.eye, 1e-5f);
  expect_near(orbit(camera, 360, 0).eye, camera.eye, 1e-5f);
}

TEST(Camera, OrbitStopsBeforeThePoles) {
  Camera camera;
  camera.eye = vec3(0, 0, 4);
  for (const float pitch : {200.0f, -200.0f}) {
    const Camera there = orbit(camera, 0, pitch);
    const float elevation = glm::degrees(std::asin(there.eye.y / 4));
    EXPECT_NEAR(std::abs(elevation), 89, 0.05f);
    EXPECT_GT(there.eye.z, 0);
  }
}

TEST(Camera, PanMovesThePictureByItsFraction) {
  Camera camera;
  camera.eye = vec3(0, 0, 10);
  camera.fov_degrees = 60;
  const Camera moved = pan(camera, 0, 1);
  // One height of the picture at the target: 2 tan(30) * 10.
  EXPECT_NEAR(moved.target.y, 2 * std::tan(glm::radians(30.0f)) * 10, 1e-4f);
  expect_near(moved.eye - moved.target, camera.eye - camera.target, 1e-5f);
}

TEST(Camera, DollyScalesTheDistanceWithinLimits) {
  Camera camera;
  camera.eye = vec3(0, 0, 10);
  EXPECT_NEAR(dolly(camera, 0.5f).eye.z, 5, 1e-5f);
  EXPECT_GT(dolly(camera, 0).eye.z, 0);
  EXPECT_LE(dolly(camera, 1e30f).eye.z, 1e4f);
}

TEST(Camera, FitShowsTheWholeSphereAroundTheBox) {
  Bounds bounds;
  bounds.extend(vec3(-1, 0, -2));
  bounds.extend(vec3(3, 1, 2));
  for (const float aspect : {0.5f, 1.0f, 2.0f}) {
    const Camera camera = default_camera(bounds, aspect);
    const CameraFrame frame = camera_frame(camera, aspect);
    for (int i = 0; i < 8; ++i) {
      const vec3 corner(i & 1 ? bounds.hi.x : bounds.lo.x, i & 2 ? bounds.hi.y : bounds.lo.y,
                        i & 4 ? bounds.hi.z : bounds.lo.z);
      const vec3 d = corner - frame.origin;
      const float depth = glm::dot(d, frame.forward);
      EXPECT_LE(std::abs(glm::dot(d, frame.right)) / glm::dot(frame.right, frame.right), depth * 1.0001f);
      EXPECT_LE(std::abs(glm::dot(d, frame.up)) / glm::dot(frame.up, frame.up), depth * 1.0001f);
    }
  }
  const Camera camera;
  EXPECT_EQ(fit(camera, Bounds{}, 1), camera);
}

TEST(Camera, FitPutsPointsInTheMiddleUpToTheMargin) {
  // A long thing, seen at an angle.
  const std::vector<vec3> points = {vec3(-3, 0, 1), vec3(4, 0.2f, -1), vec3(0, 1, 0), vec3(1, -0.5f, 2)};
  Camera camera;
  camera.eye = vec3(5, 4, 6);
  camera.fov_degrees = 30;
  for (const float aspect : {0.4f, 1.0f, 2.5f}) {
    for (const float margin : {0.0f, 0.1f}) {
      const Camera fitted = fit(camera, points, aspect, margin);
      const CameraFrame frame = camera_frame(fitted, aspect);
      float most[2] = {-2, -2}, least[2] = {2, 2};
      for (const vec3& p : points) {
        const vec3 d = p - frame.origin;
        const float depth = glm::dot(d, frame.forward);
        ASSERT_GT(depth, 0);
        const float at[2] = {glm::dot(d, frame.right) / glm::dot(frame.right, frame.right) / depth,
                             glm::dot(d, frame.up) / glm::dot(frame.up, frame.up) / depth};
        for (int i = 0; i < 2; ++i) {
          most[i] = std::max(most[i], at[i]);
          least[i] = std::min(least[i], at[i]);
        }
      }
      // One side of the picture is used up to the margin at both ends, the other is not exceeded.
      const float edge = 1 - 2 * margin;
      const int tight = most[0] > most[1] ? 0 : 1;
      EXPECT_NEAR(most[tight], edge, 1e-4f);
      EXPECT_NEAR(least[tight], -edge, 1e-4f);
      EXPECT_LE(std::max(most[1 - tight], -least[1 - tight]), edge);
      EXPECT_TRUE(in_view(fitted, points, aspect, margin - 1e-4f));
      EXPECT_FALSE(in_view(fitted, points, aspect, margin + 1e-3f));
      expect_near(glm::normalize(fitted.target - fitted.eye), glm::normalize(camera.target - camera.eye), 1e-5f);
    }
  }
  EXPECT_EQ(fit(camera, std::span<const vec3>(), 1, 0), camera);
  EXPECT_EQ(fit(camera, std::span(points).first(1), 1, 0), camera);
}

}  // namespace
}  // namespace vamp
