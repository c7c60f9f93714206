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

SceneTables build_scene_tables(const Scene& scene, const std::vector<bool>& visible) {
  CHECK(visible.size() == scene.parts.size());
  SceneTables tables;

  // Hidden parts are left out of the tree, so that they cost nothing.
  if (std::all_of(visible.begin(), visible.end(), [](bool shown) { return shown; })) {
    tables.bvh = build_bvh(scene);
  } else {
    Scene shown;
    shown.positions = scene.positions;
    std::vector<uint32_t> kept;
    for (size_t i = 0; i < scene.triangles.size(); ++i)
      if (visible[scene.triangle_part[i]]) {
        shown.triangles.push_back(scene.triangles[i]);
        shown.triangle_part.push_back(scene.triangle_part[i]);
        kept.push_back(static_cast<uint32_t>(i));
      }
    shown.parts = scene.parts;
    tables.bvh = build_bvh(shown);
    for (uint32_t& triangle : tables.bvh.order) triangle = kept[triangle];
  }

  tables.surface.reserve(4 * tables.bvh.order.size());
  const auto bits = [](float value) { return std::bit_cast<uint32_t>(value); };
  for (const uint32_t triangle : tables.bvh.order) {
    const uvec3 v = scene.triangles[triangle];
    const vec2 uv[3] = {scene.uvs[v.x], scene.uvs[v.y], scene.uvs[v.z]};
    tables.surface.emplace_back(pack_normal(scene.normals[v.x]), pack_normal(scene.normals[v.y]),
                                pack_normal(scene.normals[v.z]), scene.triangle_part[triangle]);
    tables.surface.emplace_back(bits(uv[0].x), bits(uv[0].y), bits(uv[1].x), bits(uv[1].y));
    tables.surface.emplace_back(bits(uv[2].x), bits(uv[2].y), pack_tangent(scene.tangents[v.x]),
                                pack_tangent(scene.tangents[v.y]));
    tables.surface.emplace_back(pack_tangent(scene.tangents[v.z]), 0u, 0u, 0u);
  }
  for (const Part& part : scene.parts) append_alpha(scene, part, tables);
  return tables;
}

}  // namespace vamp
