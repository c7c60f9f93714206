#pragma once
// All materials of a project in the flat tables that the kernels read, one after another; and which rows an edit
// changed.
#include <cstdint>
#include <memory>
#include <utility>
#include <vector>

#include "engine/material/known_sums.h"
#include "engine/material/tables.h"
#include "engine/project/project.h"
#include "engine/render/scene_tables.h"
#include "shaders/shared/frame.h"

namespace vamp {

struct MaterialTables {
  // Where a material's rows begin.
  struct Place {
    uint32_t texel = 0, entry = 0, basis = 0, cluster = 0, residual = 0;
    uint32_t directions = 0, triangles = 0, map = 0;
    float last_ring_cos = 1;
  };
  std::vector<Place> places;
  std::vector<std::shared_ptr<const FitSums>> sums;  // of each material in view, else null
  std::vector<tables::Texel> texels;
  std::vector<tables::Entry> entries;
  std::vector<tables::BasisRow> bases;
  std::vector<tables::ClusterRow> clusters;
  std::vector<tables::ResidualRecord> residual;      // record 0 is zero: parts without a residual read it
  std::vector<tables::DirectionTriangle> triangles;  // triangle 0 belongs to them
  std::vector<uint16_t> map;                         // and so does the first map
};

// Materials that no visible part uses are left out (their place stays zero).
Result<MaterialTables> build_material_tables(const Project& project, KnownSums& sums);

// Rows [first, first + count) of a table.
using RowRanges = std::vector<std::pair<uint32_t, uint32_t>>;

// Takes over the edit layer of one material; the rows that changed, as short ranges.
struct ChangedRows {
  RowRanges bases, clusters;
};
ChangedRows apply_edits(MaterialTables& tables, const Project& project, size_t material);

// What a pixel that saw a cluster of a material remembers of it: one of 32 bits, shared by clusters whose numbers meet.
uint32_t seen_bit(size_t material, uint32_t cluster);
uint32_t seen_bits(const Project& project, size_t material);  // all of its clusters

// The rows of the scene's parts.
std::vector<frame::PartRow> part_rows(const Project& project, const SceneTables& scene,
                                      const MaterialTables& materials);

// Index of the texel nearest to texture coordinates of a part, as the kernels find it.
size_t texel_at(const frame::PartRow& row, const vec2& uv);

// The kernel's constants that follow from the materials in view: LOBE_* bits, and SPEC_RESIDUAL.
uint32_t lobe_models_in_view(const Project& project);
uint32_t residual_in_view(const Project& project);

}  // namespace vamp
