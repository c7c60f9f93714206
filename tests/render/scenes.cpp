#include "tests/render/scenes.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "engine/brdf/registry.h"
#include "engine/core/half.h"

namespace vamp {

constexpr float kPi = 3.14159265358979f;

SceneBuilder::SceneBuilder() : scene_(std::make_shared<Scene>()) { scene_->file = "made in memory"; }

uint32_t SceneBuilder::part_of(const std::string& name) {
  const int found = scene_->find_part(name);
  if (found >= 0) return static_cast<uint32_t>(found);
  Part part;
  part.name = name;
  part.material.name = name;
  part.material.metallic = 0;
  part.material.roughness = 1;
  scene_->parts.push_back(part);
  return static_cast<uint32_t>(scene_->parts.size() - 1);
}

uint32_t SceneBuilder::add_vertex(vec3 p, vec3 n, vec2 uv) {
  scene_->positions.push_back(p);
  scene_->normals.push_back(n);
  const vec3 side = std::abs(n.y) < 0.99f ? glm::normalize(glm::cross(vec3(0, 1, 0), n)) : vec3(1, 0, 0);
  scene_->tangents.emplace_back(side, 1.0f);
  scene_->uvs.push_back(uv);
  return static_cast<uint32_t>(scene_->positions.size() - 1);
}

void SceneBuilder::add_triangle(uint32_t part, uint32_t a, uint32_t b, uint32_t c) {
  triangles_.push_back({uvec3(a, b, c), part});
}

void SceneBuilder::add_quad(const std::string& part, vec3 corner, vec3 a, vec3 b) {
  const uint32_t number = part_of(part);
  const vec3 n = glm::normalize(glm::cross(a, b));
  const uint32_t v0 = add_vertex(corner, n, {0, 0}), v1 = add_vertex(corner + a, n, {1, 0});
  const uint32_t v2 = add_vertex(corner + a + b, n, {1, 1}), v3 = add_vertex(corner + b, n, {0, 1});
  add_triangle(number, v0, v1, v2);
  add_triangle(number, v0, v2, v3);
}

void SceneBuilder::add_sphere(const std::string& part, vec3 center, float radius, int rings, bool inward) {
  const uint32_t number = part_of(part);
  const int columns = 2 * rings;
  const auto first = static_cast<uint32_t>(scene_->positions.size());
  for (int r = 0; r <= rings; ++r)
    for (int c = 0; c <= columns; ++c) {
      const float theta = kPi * static_cast<float>(r) / static_cast<float>(rings);
      const float phi = 2 * kPi * static_cast<float>(c) / static_cast<float>(columns);
      const vec3 d(std::sin(theta) * std::cos(phi), std::cos(theta), std::sin(theta) * std::sin(phi));
      add_vertex(
          center + radius * d, inward ? -d : d,
          {static_cast<float>(c) / static_cast<float>(columns), static_cast<float>(r) / static_cast<float>(rings)});
    }
  const auto at = [&](int r, int c) { return first + static_cast<uint32_t>(r * (columns + 1) + c); };
  for (int r = 0; r < rings; ++r)
    for (int c = 0; c < columns; ++c) {
      const uint32_t a = at(r, c), b = at(r + 1, c), d = at(r, c + 1), e = at(r + 1, c + 1);
      if (r > 0) inward ? add_triangle(number, a, b, d) : add_triangle(number, a, d, b);
      if (r < rings - 1) inward ? add_triangle(number, d, b, e) : add_triangle(number, d, e, b);
    }
}

void SceneBuilder::add_box(const std::string& part, vec3 lo, vec3 hi) {
  const vec3 s = hi - lo;
  const vec3 x(s.x, 0, 0), y(0, s.y, 0), z(0, 0, s.z);
  add_quad(part, lo, y, x);
  add_quad(part, lo + z, x, y);
  add_quad(part, lo, x, z);
  add_quad(part, lo + y, z, x);
  add_quad(part, lo, z, y);
  add_quad(part, lo + x, y, z);
}

void SceneBuilder::set_color(const std::string& part, vec3 color) {
  scene_->parts[part_of(part)].material.base_color = vec4(color, 1);
}

std::shared_ptr<const Scene> SceneBuilder::build() {
  std::stable_sort(triangles_.begin(), triangles_.end(),
                   [](const Triangle& a, const Triangle& b) { return a.part < b.part; });
  for (const Triangle& triangle : triangles_) {
    scene_->triangles.push_back(triangle.corners);
    scene_->triangle_part.push_back(triangle.part);
  }
  finish_scene(*scene_);
  return scene_;
}

Project dark_project(std::shared_ptr<const Scene> scene) {
  Project project = make_project(std::move(scene), "made in memory");
  project.lights.clear();
  project.ambient = project.background = vec3(0);
  project.environment = {};
  return project;
}

SpmmPtr make_rich_material(uint32_t seed) {
  std::mt19937 random(seed);
  const auto uniform = [&](float low, float high) { return std::uniform_real_distribution<float>(low, high)(random); };
  auto fit = std::make_shared<Spmm>();
  fit->width = fit->height = 16;
  fit->mm_per_texel = 1;
  fit->clusters = {{"first"}, {"second"}};
  for (const ModelRow& row : models()) {
    Basis basis;
    basis.name = std::string(row.name);
    basis.lobe = default_lobe(row.model);
    const float tilt = uniform(0, 0.6f), azimuth = uniform(0, 2 * kPi);
    basis.normal = vec3(std::sin(tilt) * std::cos(azimuth), std::sin(tilt) * std::sin(azimuth), std::cos(tilt));
    basis.psi = uniform(0, 2 * kPi);
    fit->dictionary.push_back(basis);
  }
  const auto half = [](float value) { return static_cast<uint32_t>(half_from_float(value)); };
  const int bases = static_cast<int>(fit->dictionary.size());
  for (int i = 0; i < fit->width * fit->height; ++i) {
    const uint32_t count = 3 + random() % 5, cluster = random() % 2;
    fit->texels.push_back({static_cast<uint32_t>(fit->entries.size()), cluster | count << 8,
                           half(uniform(-1, 1)) | half(uniform(-1, 1)) << 16,
                           half(uniform(-1, 1)) | half(uniform(-1, 1)) << 16});
    for (uint32_t e = 0; e < count; ++e)
      fit->entries.push_back(
          {static_cast<uint32_t>(random() % static_cast<uint32_t>(bases)) | half(uniform(0, 0.3f)) << 16,
           half(uniform(0, 0.3f)) | half(uniform(0, 0.3f)) << 16});
  }
  // The 81 directions of UBO2003: rings every 15 degrees.
  const int counts[] = {1, 6, 12, 18, 20, 24};
  for (int ring = 0; ring < 6; ++ring)
    for (int i = 0; i < counts[ring]; ++i) {
      const float theta = static_cast<float>(ring) * kPi / 12;
      const float phi = 2 * kPi * static_cast<float>(i) / static_cast<float>(counts[ring]);
      fit->residual.directions.emplace_back(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                                            std::cos(theta));
    }
  fit->residual.terms = 4;
  const size_t records = fit->clusters.size() * 81 * 81;
  for (size_t i = 0; i < records; ++i) {
    tables::ResidualRecord record{};
    for (uint32_t& word : record.halves) word = half(uniform(-0.02f, 0.03f)) | half(uniform(-0.02f, 0.03f)) << 16;
    record.halves[7] &= 0xffffu;
    fit->residual.records.push_back(record);
  }
  return fit;
}

SpmmPtr make_lacquer(float m) {
  auto fit = std::make_shared<Spmm>();
  fit->width = fit->height = 1;
  fit->clusters = {{"all"}};
  Basis base, gloss;
  base.name = "base";
  base.lobe = default_lobe(Model::lambert);
  gloss.name = "gloss";
  gloss.lobe = default_lobe(Model::cook_torrance);
  gloss.lobe.params[1] = m;
  fit->dictionary = {base, gloss};
  const auto entry = [](uint32_t basis, float w) {
    const uint32_t h = half_from_float(w);
    return tables::Entry{basis | h << 16, h | h << 16};
  };
  fit->texels = {{0, 2u << 8, 0, 0}};
  fit->entries = {entry(0, 0.1f), entry(1, 1)};
  return fit;
}

void put_material(Project& project, const std::string& part, SpmmPtr fit) {
  MaterialInstance material;
  material.name = "rich";
  material.preset = "made in memory";
  material.fit = std::move(fit);
  project.materials.push_back(material);
  project.parts[static_cast<size_t>(find_part(project, part))].material =
      static_cast<int>(project.materials.size()) - 1;
}

}  // namespace vamp
