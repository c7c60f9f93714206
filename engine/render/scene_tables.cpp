#include "engine/render/scene_tables.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "engine/core/check.h"
#include "engine/core/log.h"
#include "engine/image/image.h"

namespace vamp {
namespace {

vec2 octahedral(const vec3& n) {
  const float l1 = std::abs(n.x) + std::abs(n.y) + std::abs(n.z);
  const vec3 p = l1 > 0 ? n / l1 : vec3(0, 0, 1);
  if (p.z >= 0) return {p.x, p.y};
  return {(1 - std::abs(p.y)) * (p.x >= 0 ? 1.0f : -1.0f), (1 - std::abs(p.x)) * (p.y >= 0 ? 1.0f : -1.0f)};
}

uint32_t quantise(float value, uint32_t steps) {
  return static_cast<uint32_t>(std::lround((glm::clamp(value, -1.0f, 1.0f) * 0.5f + 0.5f) * static_cast<float>(steps)));
}

// The picture whose alpha channel is a part's mask, if it has one.
const Image* mask_of(const Scene& scene, const Part& part) {
  const int texture = part.material.base_color_texture.texture;
  if (part.material.alpha_mode == AlphaMode::opaque || texture < 0) return nullptr;
  const Image* image = scene.textures[static_cast<size_t>(texture)].image.get();
  return image->channel("A") ? image : nullptr;
}

// The alpha channel of a part's base-colour texture, 8 bits.
void append_alpha(const Scene& scene, const Part& part, SceneTables& tables) {
  const TextureSlot& slot = part.material.base_color_texture;
  tables.alpha_of_part.push_back({0, 0});
  const Image* mask = mask_of(scene, part);
  if (mask == nullptr) return;
  const Image& image = *mask;
  const auto channel = image.channel("A");
  if (slot.scale != vec2(1, 1) || slot.offset != vec2(0, 0) || slot.rotation != 0)
    spdlog::warn("part \"{}\": the texture transform of its alpha mask is left out", part.name);
  tables.alpha_of_part.back() = {static_cast<uint32_t>(tables.alpha.size()),
                                 static_cast<uint32_t>(image.width) | static_cast<uint32_t>(image.height) << 16};
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      tables.alpha.push_back(static_cast<uint8_t>(
          std::lround(glm::clamp(image.at(x, y, *channel) * part.material.base_color.w, 0.0f, 1.0f) * 255.0f)));
}

}  // namespace

bool has_alpha_mask(const Scene& scene) {
  return std::any_of(scene.parts.begin(), scene.parts.end(),
                     [&](const Part& part) { return mask_of(scene, part) != nullptr; });
}

uint32_t pack_normal(const vec3& n) {
  const vec2 p = octahedral(n);
  return quantise(p.x, 65535) | quantise(p.y, 65535) << 16;
}

uint32_t pack_tangent(const vec4& tangent) {
  const vec2 p = octahedral(vec3(tangent));
  return quantise(p.x, 65535) << 16 | quantise(p.y, 32767) << 1 | (tangent.w < 0 ? 1u : 0u);
}

void write_directions(const Scene& scene, uint32_t triangle, const RigidMotion& motion, uvec4* surface) {
  const uvec3 v = scene.triangles[triangle];
  const auto normal = [&](uint32_t vertex) { return pack_normal(motion.direction(scene.normals[vertex])); };
  const auto tangent = [&](uint32_t vertex) {
    const vec4& t = scene.tangents[vertex];
    return pack_tangent(vec4(motion.direction(vec3(t)), t.w));
  };
  surface[0].x = normal(v.x);
  surface[0].y = normal(v.y);
  surface[0].z = normal(v.z);
  surface[2].z = tangent(v.x);
  surface[2].w = tangent(v.y);
  surface[3].x = tangent(v.z);
}

SceneTables build_triangle_tables(const Scene& scene, const std::vector<bool>& visible,
                                  std::span<const RigidMotion> motions) {
  CHECK(visible.size() == scene.parts.size() && (motions.empty() || motions.size() == visible.size()));
  SceneTables tables;

  // Hidden parts are left out of the tree, so that they cost nothing. Corners stand alone: parts that move apart may
  // share vertices.
  std::vector<uint32_t> shown, part_of_shown;
  std::vector<vec3> corners;
  std::vector<uvec3> triangles;
  for (uint32_t i = 0; i < scene.triangles.size(); ++i) {
    const uint32_t part = scene.triangle_part[i];
    if (!visible[part]) continue;
    const auto first = static_cast<uint32_t>(corners.size());
    for (int k = 0; k < 3; ++k) {
      const vec3& position = scene.positions[scene.triangles[i][k]];
      corners.push_back(motions.empty() ? position : motions[part].point(position));
    }
    triangles.emplace_back(first, first + 1, first + 2);
    shown.push_back(i);
    part_of_shown.push_back(part);
  }
  tables.bvh = build_bvh(corners, triangles, part_of_shown, flags_of_parts(scene));
  for (uint32_t& triangle : tables.bvh.order) triangle = shown[triangle];

  tables.surface.reserve(4 * tables.bvh.order.size());
  const auto bits = [](float value) { return std::bit_cast<uint32_t>(value); };
  const RigidMotion at_rest;
  for (const uint32_t triangle : tables.bvh.order) {
    const uvec3 v = scene.triangles[triangle];
    const vec2 uv[3] = {scene.uvs[v.x], scene.uvs[v.y], scene.uvs[v.z]};
    const uint32_t part = scene.triangle_part[triangle];
    tables.surface.emplace_back(0u, 0u, 0u, part);
    tables.surface.emplace_back(bits(uv[0].x), bits(uv[0].y), bits(uv[1].x), bits(uv[1].y));
    tables.surface.emplace_back(bits(uv[2].x), bits(uv[2].y), 0u, 0u);
    tables.surface.emplace_back(0u);
    write_directions(scene, triangle, motions.empty() ? at_rest : motions[part], &tables.surface.end()[-4]);
  }
  return tables;
}

SceneTables build_scene_tables(const Scene& scene, const std::vector<bool>& visible) {
  SceneTables tables = build_triangle_tables(scene, visible, {});
  for (const Part& part : scene.parts) append_alpha(scene, part, tables);
  return tables;
}

}  // namespace vamp
