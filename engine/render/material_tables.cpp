#include "engine/render/material_tables.h"

#include <algorithm>
#include <cmath>
#include <cstring>

#include "engine/core/check.h"
#include "engine/material/highlight.h"

namespace vamp {
namespace {

template <class T>
uint32_t append(std::vector<T>& to, const std::vector<T>& rows) {
  const auto first = static_cast<uint32_t>(to.size());
  to.insert(to.end(), rows.begin(), rows.end());
  return first;
}

std::vector<bool> materials_in_view(const Project& project) {
  std::vector<bool> used(project.materials.size());
  for (const PartState& part : project.parts)
    if (part.visible) used[static_cast<size_t>(part.material)] = true;
  return used;
}

// Compares byte by byte: a row that comes out the same is not sent again.
template <class T>
RowRanges replace_rows(std::vector<T>& rows, uint32_t first, const std::vector<T>& now) {
  RowRanges changed;
  for (uint32_t i = 0; i < now.size(); ++i) {
    if (std::memcmp(&rows[first + i], &now[i], sizeof(T)) == 0) continue;
    rows[first + i] = now[i];
    if (!changed.empty() && changed.back().first + changed.back().second == first + i)
      ++changed.back().second;
    else
      changed.emplace_back(first + i, 1);
  }
  return changed;
}

bool has_residual(const MaterialInstance& material) {
  return !material.fit->residual.records.empty() && material.edits.residual_strength > 0;
}

uint32_t residual_terms(const MaterialInstance& material) {
  return static_cast<uint32_t>(std::min(material.edits.residual_terms, material.fit->residual.terms));
}

}  // namespace

Result<MaterialTables> build_material_tables(const Project& project, KnownSums& sums) {
  MaterialTables all;
  // What parts without a residual read: one record of zeros, reached through one triangle whose first corner has all
  // the weight, from a map that knows no other.
  all.residual.push_back({});
  all.triangles.push_back({{0, 0, 1}, 0, {0, 0, 0}, 0});
  all.map.assign(static_cast<size_t>(kDirectionMapSide * kDirectionMapSide), 0);

  const std::vector<bool> used = materials_in_view(project);
  for (size_t i = 0; i < project.materials.size(); ++i) {
    const MaterialInstance& material = project.materials[i];
    MaterialTables::Place place;
    if (!used[i]) {
      all.sums.emplace_back();
    } else {
      const Spmm& fit = *material.fit;
      place.texel = append(all.texels, fit.texels);
      place.entry = append(all.entries, fit.entries);
      all.sums.push_back(sums.of(material.fit));
      const EditedTables edited = edited_tables(fit, material.edits, all.sums.back().get());
      place.basis = append(all.bases, edited.bases);
      place.cluster = append(all.clusters, edited.clusters);
      if (!fit.residual.records.empty()) {
        place.residual = append(all.residual, fit.residual.records);
        VAMP_TRY(const DirectionTables directions, triangulate(fit.residual.directions, material.name));
        place.directions = static_cast<uint32_t>(fit.residual.directions.size());
        place.triangles = append(all.triangles, directions.triangles);
        place.map = append(all.map, directions.map);
        for (const vec3& d : fit.residual.directions) place.last_ring_cos = std::min(place.last_ring_cos, d.z);
      }
    }
    all.places.push_back(place);
  }
  return all;
}

ChangedRows apply_edits(MaterialTables& all, const Project& project, size_t material) {
  const MaterialInstance& instance = project.materials[material];
  const EditedTables edited = edited_tables(*instance.fit, instance.edits, all.sums[material].get());
  const MaterialTables::Place& place = all.places[material];
  return {replace_rows(all.bases, place.basis, edited.bases),
          replace_rows(all.clusters, place.cluster, edited.clusters)};
}

namespace {

// Neighbouring materials begin far from each other, so that few clusters of a scene share a bit.
uint32_t first_seen_bit(size_t material) { return static_cast<uint32_t>(material * 11 % 32); }

}  // namespace

uint32_t seen_bit(size_t material, uint32_t cluster) { return 1u << ((first_seen_bit(material) + cluster) % 32); }

uint32_t seen_bits(const Project& project, size_t material) {
  uint32_t bits = 0;
  for (uint32_t c = 0; c < project.materials[material].fit->clusters.size(); ++c) bits |= seen_bit(material, c);
  return bits;
}

namespace {

uint32_t highlight_code(float width) {
  if (width == 0) return 0;
  const float code = std::round(-std::log2(width) * static_cast<float>(PART_HIGHLIGHT_STEPS));
  return static_cast<uint32_t>(std::clamp(code, 1.f, 255.f));
}

}  // namespace

std::vector<frame::PartRow> part_rows(const Project& project, const SceneTables& scene,
                                      const MaterialTables& materials) {
  std::vector<frame::PartRow> rows;
  for (size_t i = 0; i < project.parts.size(); ++i) {
    const PartState& part = project.parts[i];
    const Part& geometry = project.scene->parts[i];
    const MaterialInstance& material = project.materials[static_cast<size_t>(part.material)];
    const MaterialTables::Place& place = materials.places[static_cast<size_t>(part.material)];
    const Spmm& fit = *material.fit;
    frame::PartRow row{};
    row.texel_base = place.texel;
    row.entry_base = place.entry;
    row.basis_base = place.basis;
    row.cluster_base = place.cluster;
    row.residual_base = place.residual;
    row.basis_count = static_cast<uint32_t>(fit.dictionary.size());
    row.size = static_cast<uint32_t>(fit.width) | static_cast<uint32_t>(fit.height) << 16;
    row.direction_count = place.directions;
    row.direction_triangles = place.triangles;
    row.direction_map = place.map;
    row.last_ring_cos = place.last_ring_cos;
    row.flags = first_seen_bit(static_cast<size_t>(part.material)) << PART_SEEN_SHIFT;
    if (const FitSums* sums = materials.sums[static_cast<size_t>(part.material)].get(); sums != nullptr)
      row.flags |= highlight_code(highlight_width(fit, *sums)) << PART_HIGHLIGHT_SHIFT;
    if (has_residual(material)) row.flags |= residual_terms(material) << PART_TERMS_SHIFT;

    // Texture coordinates in periods. A measured material has a size in mm; the model's own follows its texture.
    const float c = std::cos(part.texture_rotation), s = std::sin(part.texture_rotation);
    if (material.preset.empty()) {
      const TextureSlot& slot = geometry.material.base_color_texture;
      const float sc = std::cos(slot.rotation), ss = std::sin(slot.rotation);
      row.uv_xx = sc * slot.scale.x;
      row.uv_xy = ss * slot.scale.y;
      row.uv_yx = -ss * slot.scale.x;
      row.uv_yy = sc * slot.scale.y;
      row.offset_x = slot.offset.x;
      row.offset_y = slot.offset.y;
      row.rotation_cos = 1;
      row.rotation_sin = 0;
    } else {
      const vec2 period = fit.size_mm() * part.texture_scale;
      const vec2 scale = vec2(geometry.mm_per_uv) / period;
      row.uv_xx = c * scale.x;
      row.uv_xy = s * scale.x;
      row.uv_yx = -s * scale.y;
      row.uv_yy = c * scale.y;
      row.offset_x = part.texture_offset.x / period.x;
      row.offset_y = part.texture_offset.y / period.y;
      row.rotation_cos = c;
      // The frame's second axis points to falling v, where the turn goes the other way round.
      row.rotation_sin = -s;
    }
    row.mirror_f0 = part.mirror_f0;
    row.alpha_cutoff = geometry.material.alpha_cutoff;
    row.alpha_base = scene.alpha_of_part[i].x;
    row.alpha_size = scene.alpha_of_part[i].y;
    rows.push_back(row);
  }
  return rows;
}

size_t texel_at(const frame::PartRow& row, const vec2& uv) {
  const auto place = [](float p, uint32_t size) {
    const float period = p - std::floor(p);
    return std::min(static_cast<uint32_t>(period * static_cast<float>(size)), size - 1);
  };
  const uint32_t width = row.size & 0xffffu, height = row.size >> 16;
  const uint32_t x = place(row.uv_xx * uv.x + row.uv_xy * uv.y + row.offset_x, width);
  const uint32_t y = place(row.uv_yx * uv.x + row.uv_yy * uv.y + row.offset_y, height);
  return static_cast<size_t>(y) * width + x;
}

uint32_t lobe_models_in_view(const Project& project) {
  uint32_t models = 0;
  const std::vector<bool> used = materials_in_view(project);
  for (size_t i = 0; i < used.size(); ++i)
    if (used[i]) models |= lobe_models_in_use(*project.materials[i].fit, project.materials[i].edits);
  return models;
}

uint32_t residual_in_view(const Project& project) {
  uint32_t residual = 0;
  const std::vector<bool> used = materials_in_view(project);
  for (size_t i = 0; i < used.size(); ++i)
    if (used[i] && has_residual(project.materials[i]))
      residual = std::max(residual, 1 + residual_terms(project.materials[i]));
  return residual;
}

}  // namespace vamp
