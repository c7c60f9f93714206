#include "tools/shoe/studio.h"

#include <cmath>
#include <glm/gtc/quaternion.hpp>
#include <numbers>

namespace vamp::shoe {
namespace {

constexpr double kDegree = std::numbers::pi / 180.0;
constexpr double kAzimuth = 38.0;  // of the camera from the lateral side (+z) towards the toe (+x), degrees
constexpr double kElevation = 27.0;
constexpr double kDistance = 480.0;  // mm from the target
constexpr Vec3 kTarget(2.0, 52.0, 0.0);

Vec3 horizontal(double azimuth) { return {std::sin(azimuth * kDegree), 0.0, std::cos(azimuth * kDegree)}; }

// Floor and back wall in one piece, facing the camera.
Mesh seamless_sweep() {
  constexpr double kFront = 2000.0, kBack = 700.0, kRadius = 700.0, kWall = 1200.0, kHalfWidth = 2500.0;
  constexpr double kBelow = -0.05;  // a hair under the sole, so that no faces coincide
  std::vector<Vec2> profile;        // (distance towards the camera, height)
  for (int i = 0; i <= 40; ++i) profile.emplace_back(kFront - (kFront + kBack) * i / 40.0, 0.0);
  for (int i = 1; i <= 24; ++i) {
    const double turn = 0.5 * std::numbers::pi * i / 24.0;
    profile.emplace_back(-kBack - kRadius * std::sin(turn), kRadius * (1.0 - std::cos(turn)));
  }
  for (int i = 1; i <= 12; ++i) profile.emplace_back(-kBack - kRadius, kRadius + kWall * i / 12.0);
  const Vec3 towards = horizontal(kAzimuth);
  const Vec3 across = glm::cross(Vec3(0.0, 1.0, 0.0), towards);
  std::vector<Vec3> points;
  std::vector<Vec2> uvs;
  double along = 0.0;
  for (size_t j = 0; j < profile.size(); ++j) {
    if (j > 0) along += glm::distance(profile[j], profile[j - 1]);
    for (int i = 0; i <= 20; ++i) {
      const double side = kHalfWidth * (i / 10.0 - 1.0);
      points.push_back(side * across + profile[j].x * towards + Vec3(0.0, profile[j].y + kBelow, 0.0));
      uvs.emplace_back(side, along);
    }
  }
  Mesh mesh = grid(points, uvs, 21);
  mesh.smooth();
  return mesh;
}

double rounded(double value) { return std::round(value * 1e7) / 1e7; }

// A node at `eye` (mm) whose -Z looks at `target`.
Json looking(const std::string& name, const Vec3& eye, const Vec3& target) {
  const Vec3 back = glm::normalize(eye - target);
  const Vec3 right = glm::normalize(glm::cross(Vec3(0.0, 1.0, 0.0), back));
  const glm::dquat turn = glm::quat_cast(glm::dmat3(right, glm::cross(back, right), back));
  const Vec3 at = eye / kMmPerUnit;
  return {{"name", name},
          {"translation", {rounded(at.x), rounded(at.y), rounded(at.z)}},
          {"rotation", {rounded(turn.x), rounded(turn.y), rounded(turn.z), rounded(turn.w)}}};
}

Json light(const std::string& name, const Vec3& eye, double width, double height, double power, const Vec3& colour) {
  Json node = looking(name + " light", eye, kTarget);
  node["extras"]["vamp_light"] = {{"type", "rect"},
                                  {"width", width},
                                  {"height", height},
                                  {"power", power},
                                  {"color", {colour.x, colour.y, colour.z}},
                                  {"name", name}};
  return node;
}

}  // namespace

void add_studio(Scene& scene) {
  scene.parts.push_back({"Studio floor", Vec3(0.32), 0.9, 0.0, seamless_sweep()});

  scene.cameras.push_back(
      {{"name", "Three-quarter view"},
       {"type", "perspective"},
       {"perspective", {{"yfov", rounded(28.0 * kDegree)}, {"aspectRatio", 1.36}, {"znear", 0.01}, {"zfar", 20.0}}}});
  const Vec3 from =
      std::cos(kElevation * kDegree) * horizontal(kAzimuth) + Vec3(0.0, std::sin(kElevation * kDegree), 0.0);
  Json camera = looking("Camera", kTarget + kDistance * from, kTarget);
  camera["camera"] = 0;
  scene.nodes.push_back(camera);

  // The key from the left of the camera and above, a little behind the shoe so that edges catch it; the fill from the
  // right.
  const auto place = [](double azimuth, double elevation, double distance) {
    return kTarget + distance * (std::cos(elevation * kDegree) * horizontal(azimuth) +
                                 Vec3(0.0, std::sin(elevation * kDegree), 0.0));
  };
  scene.nodes.push_back(light("Key", place(kAzimuth - 75.0, 52.0, 1000.0), 0.7, 0.5, 8.5, {1.0, 0.97, 0.93}));
  scene.nodes.push_back(light("Fill", place(kAzimuth + 70.0, 38.0, 1300.0), 1.0, 0.8, 5.0, {0.93, 0.97, 1.0}));

  scene.extras = {{"vamp_ambient", {0.15, 0.15, 0.15}}, {"vamp_ao_radius", 0.12}};
}

}  // namespace vamp::shoe
