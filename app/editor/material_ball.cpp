#include "app/editor/material_ball.h"

#include <cmath>
#include <numbers>

#include "app/editor/background_device.h"
#include "engine/gpu/device.h"
#include "engine/image/display.h"
#include "engine/image/save.h"
#include "engine/project/studio.h"
#include "engine/render/still.h"

namespace vamp {
namespace {

constexpr int kSide = 192;
constexpr uint32_t kSamples = 48;
constexpr float kRadius = 0.03f;  // m: large enough for a tile of leather, small enough to show its grain

// A ball of latitude and longitude; its texture runs around twice as far as from pole to pole, so that the scale at
// the equator is the same both ways. The seam and the poles face away from the camera.
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
      scene->uvs.emplace_back(2 * u, v);
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
  project.camera = {.eye = vec3(0, 0.045f, 0.2f), .target = vec3(0), .fov_degrees = 18.5f};
  project.lights = studio_lights(project.scene->bounds);
  VAMP_TRY(const std::unique_ptr<gpu::Device> device, background_device(window_device));
  const StillOptions options{.width = kSide, .height = kSide, .samples = kSamples};
  VAMP_TRY(const Still still,
           render_still(*device, std::make_shared<const Project>(std::move(project)), options, &progress));
  VAMP_TRY(const Image shown, displayed(still.image, {}));
  return encode_png(shown);
}

}  // namespace vamp
