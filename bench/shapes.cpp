#include "bench/shapes.h"

#include <fmt/format.h>

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

// Triangles of each part: a scene has them part by part.
using Parts = std::array<std::vector<uvec3>, kShapesParts>;

// Rings of 2 n vertices from pole to pole; every ring but the outermost gives two triangles a vertex.
void add_ball(Scene& scene, Parts& parts, const Ball& ball, float phase, int n) {
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
      // Two stripes of each part, so that every part is seen from any side.
      std::vector<uvec3>& part = parts[static_cast<size_t>(j * kShapesParts / n % kShapesParts)];
      if (i > 0) part.emplace_back(at(i, j), at(i, j + 1), at(i + 1, j + 1));
      if (i < n - 1) part.emplace_back(at(i, j), at(i + 1, j + 1), at(i + 1, j));
    }
}

void add_floor(Scene& scene, Parts& parts) {
  for (uint32_t part = 0; part < kShapesParts; ++part) {
    const auto base = static_cast<uint32_t>(scene.positions.size());
    const float left = 2.f * static_cast<float>(part) / kShapesParts - 1, right = left + 2.f / kShapesParts;
    for (const vec2 corner : {vec2(left, -1), vec2(left, 1), vec2(right, 1), vec2(right, -1)}) {
      scene.positions.emplace_back(2.5f * corner.x, -0.1f, 2.5f * corner.y);
      scene.normals.emplace_back(0, 1, 0);
      scene.tangents.emplace_back(1, 0, 0, -1);
      scene.uvs.push_back(2.5f * corner);
    }
    parts[part].emplace_back(base, base + 1, base + 2);
    parts[part].emplace_back(base, base + 2, base + 3);
  }
}

}  // namespace

Project shapes_project(int triangles) {
  auto scene = std::make_shared<Scene>();
  scene->name = "shapes";
  scene->parts.resize(kShapesParts);
  for (size_t i = 0; i < scene->parts.size(); ++i) scene->parts[i].name = fmt::format("Stripes {}", i + 1);
  Parts parts;
  const int rings = std::max(static_cast<int>(std::sqrt(triangles / 20.0) + 0.5), 3);
  for (size_t i = 0; i < kBalls.size(); ++i) add_ball(*scene, parts, kBalls[i], static_cast<float>(i), rings);
  add_floor(*scene, parts);
  for (uint32_t part = 0; part < kShapesParts; ++part) {
    scene->triangles.insert(scene->triangles.end(), parts[part].begin(), parts[part].end());
    scene->triangle_part.resize(scene->triangles.size(), part);
  }
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
