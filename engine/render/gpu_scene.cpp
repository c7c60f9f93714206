#include "engine/render/gpu_scene.h"

#include <algorithm>
#include <glm/geometric.hpp>

#include "engine/gpu/device.h"

namespace vamp {
namespace {

// The kernels' numbers of the light types.
static_assert(static_cast<int>(LightType::point) == LIGHT_POINT && static_cast<int>(LightType::spot) == LIGHT_SPOT &&
              static_cast<int>(LightType::directional) == LIGHT_DIRECTIONAL &&
              static_cast<int>(LightType::rect) == LIGHT_RECT && static_cast<int>(LightType::disk) == LIGHT_DISK &&
              static_cast<int>(LightType::sphere) == LIGHT_SPHERE);

using gpu::Usage;

// Makes the buffer and its view; an empty table becomes one row of zeros, for a view must have a texel.
template <class T>
Result<uint64_t> send(gpu::Device& device, TexelTable<T>& table, const char* name, VkFormat format,
                      const std::vector<T>& rows, Usage besides = Usage::none) {
  const std::vector<T> zero(1);
  const std::vector<T>& filled = rows.empty() ? zero : rows;
  const uint64_t bytes = filled.size() * sizeof(T);
  VAMP_CHECK_STATUS(device.fits_texel_view(name, bytes / gpu::texel_bytes(format)));
  table.rows = gpu::TypedBuffer<T>(device, name, filled.size(), Usage::uniform_texel | besides);
  table.view = gpu::TexelView(device, table.rows, format);
  return device.upload_rows<T>(table.rows, 0, filled);
}

}  // namespace

Result<uint64_t> GpuScene::send_scene(gpu::Device& device, const SceneTables& from, const TracePath& path) {
  const Bvh& bvh = from.bvh;
  if (path.storage_fetch) {
    VAMP_CHECK_STATUS(device.fits_storage_range("nodes", bvh.nodes.size() * sizeof(uvec4)));
    VAMP_CHECK_STATUS(device.fits_storage_range("boxes", bvh.list.size() * sizeof(uvec4)));
    VAMP_CHECK_STATUS(device.fits_storage_range("triangles", bvh.triangles.size() * sizeof(vec4)));
  }
  VAMP_TRY(uint64_t bytes, send(device, nodes, "nodes", VK_FORMAT_R32G32B32A32_SFLOAT, bvh.nodes, Usage::storage));
  VAMP_TRY(const uint64_t b0, send(device, boxes, "boxes", VK_FORMAT_R32G32B32A32_SFLOAT, bvh.list, Usage::storage));
  const Usage read = path.ray_queries ? Usage::storage | Usage::ray_input : Usage::storage;
  VAMP_TRY(const uint64_t b1, send(device, triangles, "triangles", VK_FORMAT_R32G32B32A32_SFLOAT, bvh.triangles, read));
  VAMP_TRY(const uint64_t b2, send(device, surface, "surface", VK_FORMAT_R32G32B32A32_UINT, from.surface));
  VAMP_TRY(const uint64_t b3, send(device, alpha, "alpha masks", VK_FORMAT_R8_UINT, from.alpha));
  rays = {};
  if (path.ray_queries) {
    rays = gpu::AccelerationStructure(device, "rays", triangles.rows, static_cast<uint32_t>(bvh.triangle_count()));
    build_rays(device);
  }
  return bytes + b0 + b1 + b2 + b3;
}

void GpuScene::build_rays(gpu::Device& device) const {
  if (!rays) return;
  gpu::CommandList list = device.begin("rays");
  list.build(rays);
  device.submit(std::move(list));
}

uint64_t GpuScene::send_moved(gpu::Device& device, const SceneTables& from, const MovedRows& rows) {
  if (rows.triangles.empty()) return 0;
  uint64_t bytes = device.upload_rows<uvec4>(nodes.rows, 0, from.bvh.nodes);
  bytes += device.upload_rows<uvec4>(boxes.rows, 0, from.bvh.list);
  for (const auto& [first, count] : rows.triangles) {
    bytes += device.upload_rows<vec4>(triangles.rows, 3 * uint64_t{first},
                                      std::span(from.bvh.triangles).subspan(3 * size_t{first}, 3 * size_t{count}));
    if (rows.turned)
      bytes += device.upload_rows<uvec4>(surface.rows, 4 * uint64_t{first},
                                         std::span(from.surface).subspan(4 * size_t{first}, 4 * size_t{count}));
  }
  build_rays(device);
  return bytes;
}

Result<uint64_t> GpuScene::send_materials(gpu::Device& device, const MaterialTables& from) {
  VAMP_TRY(uint64_t bytes, send(device, texels, "texels", VK_FORMAT_R32G32B32A32_UINT, from.texels));
  VAMP_TRY(const uint64_t b1, send(device, entries, "entries", VK_FORMAT_R32G32_UINT, from.entries));
  VAMP_TRY(const uint64_t b2, send(device, bases, "bases", VK_FORMAT_R32G32B32A32_SFLOAT, from.bases));
  VAMP_TRY(const uint64_t b3, send(device, clusters, "clusters", VK_FORMAT_R32G32B32A32_SFLOAT, from.clusters));
  VAMP_TRY(const uint64_t b4, send(device, residual, "residual", VK_FORMAT_R32G32B32A32_UINT, from.residual));
  VAMP_TRY(const uint64_t b5,
           send(device, direction_triangles, "direction triangles", VK_FORMAT_R32G32B32A32_SFLOAT, from.triangles));
  VAMP_TRY(const uint64_t b6, send(device, direction_map, "direction map", VK_FORMAT_R16_UINT, from.map));
  return bytes + b1 + b2 + b3 + b4 + b5 + b6;
}

Result<uint64_t> GpuScene::send_parts(gpu::Device& device, const std::vector<frame::PartRow>& rows) {
  return send(device, parts, "parts", VK_FORMAT_R32G32B32A32_UINT, rows);
}

Result<uint64_t> GpuScene::send_environment(gpu::Device& device, const Environment* map) {
  const std::vector<vec4> no_texels;
  const std::vector<Environment::Cell> no_cells;
  VAMP_TRY(uint64_t bytes, send(device, environment, "environment", VK_FORMAT_R32G32B32A32_SFLOAT,
                                map != nullptr ? map->texels : no_texels));
  VAMP_TRY(const uint64_t b1, send(device, environment_cells, "environment cells", VK_FORMAT_R32G32_UINT,
                                   map != nullptr ? map->cells : no_cells));
  return bytes + b1;
}

uint64_t GpuScene::send_lights(gpu::Device& device, const std::vector<frame::LightRow>& rows) {
  if (!lights.rows) {
    lights.rows =
        gpu::TypedBuffer<frame::LightRow>(device, "lights", MAX_LIGHTS, Usage::uniform_texel | Usage::storage);
    lights.view = gpu::TexelView(device, lights.rows, VK_FORMAT_R32G32B32A32_SFLOAT);
  }
  return rows.empty() ? 0 : device.upload_rows<frame::LightRow>(lights.rows, 0, rows);
}

void GpuScene::bind(const gpu::Device& device, std::vector<gpu::Bound>& bound) const {
  // Kernels that fetch through texel buffers never read these: what the range cannot hold is left out.
  const uint64_t range = device.info().max_storage_range;

  bound.insert(bound.end(), {{BINDING_PARAMS, params},
                             {BINDING_LIGHTS, lights.rows},
                             {BINDING_LIGHT_TEXELS, lights.view},
                             {BINDING_NODES, nodes.view},
                             {BINDING_TRIANGLES, triangles.view},
                             {BINDING_BOXES, boxes.view},
                             {BINDING_BOXES_STORAGE, boxes.rows, 0, std::min(boxes.rows.bytes(), range)},
                             {BINDING_NODES_STORAGE, nodes.rows, 0, std::min(nodes.rows.bytes(), range)},
                             {BINDING_TRIANGLES_STORAGE, triangles.rows, 0, std::min(triangles.rows.bytes(), range)},
                             {BINDING_SURFACE, surface.view},
                             {BINDING_PARTS, parts.view},
                             {BINDING_TEXELS, texels.view},
                             {BINDING_ENTRIES, entries.view},
                             {BINDING_BASES, bases.view},
                             {BINDING_CLUSTERS, clusters.view},
                             {BINDING_RESIDUAL, residual.view},
                             {BINDING_DIRECTION_TRIANGLES, direction_triangles.view},
                             {BINDING_DIRECTION_MAP, direction_map.view},
                             {BINDING_ENVIRONMENT, environment.view},
                             {BINDING_ENVIRONMENT_CELLS, environment_cells.view},
                             {BINDING_ALPHA, alpha.view}});
  if (rays) bound.emplace_back(BINDING_RAYS, rays);
}

namespace {

float extent_of(const Light& light) {
  switch (light.type) {
    case LightType::rect:
      return 0.5f * glm::length(light.size);
    case LightType::disk:
    case LightType::sphere:
      return light.radius;
    default:
      return 0;
  }
}

}  // namespace

frame::LightRow light_row(const Light& light, float scene_radius) {
  const LightFrame axes = light_frame(light);
  const SpotFalloff spot = spot_falloff(light);
  frame::LightRow row{};
  row.center = light.center;
  row.type = static_cast<uint32_t>(light.type);
  row.u = axes.u;
  row.v = axes.v;
  row.n = axes.n;
  row.half_width = 0.5f * light.size.x;
  row.half_height = 0.5f * light.size.y;
  row.radius = light.radius;
  row.area = light.type == LightType::directional ? 1 / (scene_radius * scene_radius) : light_area(light);
  row.extent = extent_of(light);
  row.spot_scale = spot.scale;
  row.spot_offset = spot.offset;
  return row;
}

}  // namespace vamp
