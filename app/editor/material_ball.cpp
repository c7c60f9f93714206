#include "app/editor/material_ball.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <numbers>
#include <string>

#include "app/editor/background_device.h"
#include "engine/gpu/device.h"
#include "engine/image/display.h"
#include "engine/image/save.h"
#include "engine/render/still.h"

namespace vamp {
namespace {

// As the shipped presets are photographed (engine/fit/swatch.cpp), so that a library looks like one.
constexpr int kSide = 256;
constexpr uint32_t kSamples = 48;
constexpr float kRadius = 0.015f;  // m: large enough for a tile of leather, small enough to show its grain
constexpr float kFrame = 1.1f;     // half the picture's side over the radius
constexpr float kGround = 0.22f;
constexpr float kAmbient = 0.12f;

struct Lamp {
  vec3 direction;
  float spread;  // radius over distance
  float irradiance;
};
constexpr std::array kLamps{Lamp{{-0.5f, 0.6f, 0.8f}, 0.17f, 2.7f}, Lamp{{0.85f, 0.15f, 0.55f}, 0.6f, 0.55f},
                            Lamp{{0.45f, 0.6f, -0.25f}, 0.3f, 0.8f}, Lamp{{0, 1, 0.25f}, 0.9f, 0.5f}};

std::vector<Light> ball_lights() {
  constexpr float kDistance = 8 * kRadius;
  std::vector<Light> lights;
  for (const Lamp& lamp : kLamps) {
    Light light;
    light.name = "Lamp " + std::to_string(lights.size() + 1);
    light.type = LightType::disk;
    light.center = kDistance * glm::normalize(lamp.direction);
    light.target = vec3(0);
    light.radius = lamp.spread * kDistance;
    // On the axis of a disk: E = P / (pi (d^2 + r^2)).
    light.power = lamp.irradiance * std::numbers::pi_v<float> * (kDistance * kDistance + light.radius * light.radius);
    lights.push_back(light);
  }
  return lights;
}

// The ball before a ground with its soft shadow, as light of a display.
Image on_ground(const Image& ball) {
  Image picture(kSide, kSide, {"R", "G", "B"});
  const auto shoulder = [](float value) {
    constexpr float kStart = 0.75f;
    if (value < kStart) return std::max(value, 0.0f);
    return 1 - (1 - kStart) * std::exp(-(value - kStart) / (1 - kStart));
  };
  for (int row = 0; row < kSide; ++row)
    for (int column = 0; column < kSide; ++column) {
      const float x = kFrame * (2 * (static_cast<float>(column) + 0.5f) / kSide - 1);
      const float y = kFrame * (1 - 2 * (static_cast<float>(row) + 0.5f) / kSide);
      const float across = x / 0.9f, below = (y + 1.02f) / 0.16f;
      const float shadow = 1 - 0.45f * std::exp(-(across * across + below * below));
      const float ground = kGround * shadow * (1 - 0.25f * std::max(x * x + y * y - 1, 0.0f));
      for (size_t c = 0; c < 3; ++c)
        picture.at(column, row, c) = shoulder(ball.at(column, row, c) + (1 - ball.at(column, row, 3)) * ground);
    }
  return picture;
}

// A ball of latitude and longitude, whose grain runs round it as on a turned part. The seam faces away from the camera.
std::shared_ptr<const Scene> make_ball() {
  constexpr int kAround = 96, kDown = 48;
  constexpr float kPi = std::numbers::pi_v<float>;
  auto scene = std::make_shared<Scene>();
  scene->name = "Ball";
  scene->parts.push_back({.name = "Ball"});
  for (int j = 0; j <= kDown; ++j) {
    for (int i = 0; i <= kAround; ++i) {
      const float u = static_cast<float>(i) / kAround, v = static_cast<float>(j) / kDown;
      const float phi = 2 * kPi * u, theta = kPi * v;
      const vec3 normal(std::sin(theta) * -std::sin(phi), std::cos(theta), std::sin(theta) * -std::cos(phi));
      scene->positions.push_back(kRadius * normal);
      scene->normals.push_back(normal);
      scene->tangents.emplace_back(-std::cos(phi), 0.0f, std::sin(phi), 1.0f);
      const float latitude = kPi / 2 - theta;
      scene->uvs.emplace_back((phi - kPi) * std::cos(0.6f * latitude), -latitude);
    }
  }
  for (int j = 0; j < kDown; ++j) {
    for (int i = 0; i < kAround; ++i) {
      const uint32_t a = static_cast<uint32_t>(j * (kAround + 1) + i), b = a + 1, c = a + kAround + 1, d = c + 1;
      if (j > 0) scene->triangles.emplace_back(a, c, b);
      if (j + 1 < kDown) scene->triangles.emplace_back(b, c, d);
    }
  }
  scene->triangle_part.assign(scene->triangles.size(), 0);
  finish_scene(*scene);
  return scene;
}

}  // namespace

Result<std::vector<std::byte>> render_material_ball(gpu::Device& window_device, const Preset& preset,
                                                    Progress& progress) {
  Project project = make_project(make_ball(), {});
  assign_preset(project, 0, preset, "");
  // From so far that it is next to a parallel projection.
  constexpr float kAway = 12;
  project.camera = {.eye = vec3(0, 0, kAway * kRadius),
                    .target = vec3(0),
                    .fov_degrees = glm::degrees(2 * std::atan(kFrame / kAway))};
  project.lights = ball_lights();
  project.ambient = vec3(kAmbient);
  project.background = vec3(0);
  VAMP_TRY(const std::unique_ptr<gpu::Device> device, background_device(window_device));
  const StillOptions options{.width = kSide, .height = kSide, .samples = kSamples};
  VAMP_TRY(const Still still,
           render_still(*device, std::make_shared<const Project>(std::move(project)), options, &progress));
  VAMP_TRY(const Image shown, displayed(on_ground(still.image), {.curve = ToneCurve::linear}));
  return encode_png(shown);
}

}  // namespace vamp
