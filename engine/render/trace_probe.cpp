#include "engine/render/trace_probe.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <memory>
#include <numbers>
#include <vector>

#include "engine/core/clock.h"
#include "engine/gpu/device.h"
#include "engine/render/renderer.h"

namespace vamp {
namespace {

// A bumpy ball of 20,000 triangles on nothing, seen from near by.
Project probe_project() {
  constexpr int kRings = 72;
  auto scene = std::make_shared<Scene>();
  scene->parts.resize(1);
  for (int i = 0; i <= kRings; ++i)
    for (int j = 0; j < 2 * kRings; ++j) {
      const float theta = std::numbers::pi_v<float> * static_cast<float>(i) / kRings;
      const float phi = std::numbers::pi_v<float> * static_cast<float>(j) / kRings;
      const vec3 out(std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi));
      scene->positions.push_back((1 + 0.1f * std::sin(9 * theta) * std::sin(11 * phi)) * out);
      scene->normals.push_back(out);
      scene->tangents.emplace_back(-std::sin(phi), 0, std::cos(phi), 1);
      scene->uvs.emplace_back(0);
    }
  const auto at = [](int i, int j) { return static_cast<uint32_t>(i * 2 * kRings + j % (2 * kRings)); };
  for (int i = 0; i < kRings; ++i)
    for (int j = 0; j < 2 * kRings; ++j) {
      if (i > 0) scene->triangles.emplace_back(at(i, j), at(i, j + 1), at(i + 1, j + 1));
      if (i < kRings - 1) scene->triangles.emplace_back(at(i, j), at(i + 1, j + 1), at(i + 1, j));
    }
  scene->triangle_part.resize(scene->triangles.size());
  scene->lights.emplace_back();
  finish_scene(*scene);
  Project project = make_project(scene, "probe");
  project.camera.eye = vec3(0, 1, 2.2f);
  project.camera.target = vec3(0);
  return project;
}

}  // namespace

Timings time_traces(gpu::Device& device, const TracePath& first, const TracePath& second) {
  constexpr int kSide = 160, kRounds = 7;
  const auto project = std::make_shared<const Project>(probe_project());
  std::array<std::unique_ptr<Renderer>, 2> renderers;
  std::array<std::vector<double>, 2> ms;
  for (size_t way = 0; way < 2; ++way) {
    renderers[way] = std::make_unique<Renderer>(device);
    renderers[way]->set_trace_path(way == 0 ? first : second);
    if (const auto taken = renderers[way]->set_project(project); !taken)
      throw MachineError(taken.error().kind, taken.error().message());
    renderers[way]->set_region(kSide, kSide, {0, 0, kSide, kSide});
  }
  // The first compiles.
  for (int round = -1; round < kRounds; ++round)
    for (size_t way = 0; way < 2; ++way) {
      const Clock::time_point start = Clock::now();
      device.wait(renderers[way]->render_occlusion(0, SAMPLES_PER_HIT));
      if (round >= 0) ms[way].push_back(1e3 * seconds_since(start));
    }
  for (auto& series : ms) std::nth_element(series.begin(), series.begin() + kRounds / 2, series.end());
  return {ms[0][kRounds / 2], ms[1][kRounds / 2]};
}

}  // namespace vamp
