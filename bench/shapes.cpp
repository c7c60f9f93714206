#include "bench/shapes.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "bench/material.h"

namespace vamp {
namespace {

struct Ball {
  float x, z, radius;
};
constexpr std::array<Ball, 5> kBalls{
    {{0, 0, 0.6f}, {1.2f, 0.3f, 0.45f}, {-1.1f, 0.5f, 0.5f}, {0.4f, -1.2f, 0.4f}, {-0.6f, -1.0f, 0.35f}}};

// Rings of 2 n vertices from pole to pole; every ring but the outermost gives two triangles a vertex.
void add_ball(Scene& scene, const Ball& ball, float phase, int n) {
  const auto base = static_cast<uint32_t>(scene.positions.size());
  const float pi = std::numbers::pi_v<float>;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j < 2 * n; ++j) {
      const float theta = pi * static_cast<float>(i) / static_cast<float>(n);
      const float phi = pi * static_cast<float>(j) / static_cast<float>(n);
      const vec3 out(std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi));
      const float bumps =
          0.08f * std::sin(7 * theta + phase) * std::sin(9 * phi) + 0.02f * std::sin(31 * theta) * std::sin(29 * phi);
      scene.positions.push_back(vec3(ball.x, ball.radius, ball.z) + ball.radius * (1 + bumps) * out);
      scene.normals.push_back(out);
      scene.tangents.emplace_back(-std::sin(phi), 0, std::cos(phi), 1);
      scene.uvs.emplace_back(static_cast<float>(j) / static_cast<float>(n),
                             static_cast<float>(i) / static_cast<float>(n));
    }
  const auto at = [&](int i, int j) { return base + static_cast<uint32_t>(i * 2 * n + j % (2 * n)); };
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < 2 * n; ++j) {
      if (i > 0) scene.triangles.emplace_back(at(i, j), at(i, j + 1), at(i + 1, j + 1));
      if (i < n - 1) scene.triangles.emplace_back(at(i, j), at(i + 1, j + 1), at(i + 1, j));
    }
}

void add_floor(Scene& scene) {
  const auto base = static_cast<uint32_t>(scene.positions.size());
  for (const vec2 corner : {vec2(-1, -1), vec2(-1, 1), vec2(1, 1), vec2(1, -1)}) {
    scene.positions.emplace_back(2.5f * corner.x, -0.1f, 2.5f * corner.y);
    scene.normals.emplace_back(0, 1, 0);
    scene.tangents.emplace_back(1, 0, 0, -1);
    scene.uvs.push_back(2.5f * corner);
  }
  scene.triangles.emplace_back(base, base + 1, base + 2);
  scene.triangles.emplace_back(base, base + 2, base + 3);
}

}  // namespace

Project shapes_project(int triangles) {
  auto scene = std::make_shared<Scene>();
  scene->name = "shapes";
  Part part;
  part.name = "Shapes";
  scene->parts = {part};
  const int rings = std::max(static_cast<int>(std::sqrt(triangles / 20.0) + 0.5), 3);
  for (size_t i = 0; i < kBalls.size(); ++i) add_ball(*scene, kBalls[i], static_cast<float>(i), rings);
  add_floor(*scene);
  scene->triangle_part.assign(scene->triangles.size(), 0);
  finish_scene(*scene);

  Project project = make_project(scene, "shapes");
  dress(project, {.used = {Model::lambert, Model::blinn_phong, Model::ward, Model::cook_torrance}});
  project.camera.eye = vec3(0, 2.4f, 4.2f);
  project.camera.target = vec3(0, 0.3f, 0);
  project.camera.fov_degrees = 40;
  Light light;
  light.center = vec3(1.5f, 3, 2);
  light.target = vec3(0);
  light.size = vec2(0.8f);
  project.lights = {light};
  project.ambient = vec3(0.2f);
  project.settings.ao_radius = 1;
  return project;
}

}  // namespace vamp
