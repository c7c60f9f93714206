#pragma once
// The tables of a project on the device.
#include <string>
#include <vector>

#include "engine/gpu/acceleration_structure.h"
#include "engine/gpu/buffer.h"
#include "engine/gpu/pipeline.h"
#include "engine/render/kernel_key.h"
#include "engine/render/material_tables.h"
#include "engine/render/placed_scene.h"
#include "engine/render/scene_tables.h"
#include "engine/scene/environment.h"
#include "engine/scene/light.h"
#include "shaders/shared/frame.h"

namespace vamp {

// A table that kernels fetch through a texel buffer (and, where asked for, a storage buffer).
template <class T>
struct TexelTable {
  gpu::TypedBuffer<T> rows;
  gpu::TexelView view;
};

struct GpuScene {
  gpu::TypedBuffer<frame::FrameParams> params;
  TexelTable<frame::LightRow> lights;
  TexelTable<uvec4> nodes;
  TexelTable<uvec4> boxes;
  TexelTable<vec4> triangles;
  gpu::AccelerationStructure rays;  // of the triangles, where the device traces them
  TexelTable<uvec4> surface;
  TexelTable<frame::PartRow> parts;
  TexelTable<tables::Texel> texels;
  TexelTable<tables::Entry> entries;
  TexelTable<tables::BasisRow> bases;
  TexelTable<tables::ClusterRow> clusters;
  TexelTable<tables::ResidualRecord> residual;
  TexelTable<tables::DirectionTriangle> direction_triangles;
  TexelTable<uint16_t> direction_map;
  TexelTable<vec4> environment;
  TexelTable<Environment::Cell> environment_cells;
  TexelTable<uint8_t> alpha;

  // Each makes its buffers anew and fills them. Errors: a table larger than the device allows. Return bytes sent.
  Result<uint64_t> send_scene(gpu::Device& device, const SceneTables& tables, const TracePath& path);
  // Into the buffers that are there: what parts that moved have changed of the same tree.
  uint64_t send_moved(gpu::Device& device, const SceneTables& tables, const MovedRows& rows);
  Result<uint64_t> send_materials(gpu::Device& device, const MaterialTables& tables);
  Result<uint64_t> send_parts(gpu::Device& device, const std::vector<frame::PartRow>& rows);
  Result<uint64_t> send_environment(gpu::Device& device, const Environment* map);
  uint64_t send_lights(gpu::Device& device, const std::vector<frame::LightRow>& rows);

  // After triangles have moved in their table: what the device traces follows. Nothing where the program does.
  void build_rays(gpu::Device& device) const;

  // What a descriptor set needs of these, appended.
  void bind(const gpu::Device& device, std::vector<gpu::Bound>& bound) const;
};

// The kernel's row of a light in a scene of this radius.
frame::LightRow light_row(const Light& light, float scene_radius);

}  // namespace vamp
