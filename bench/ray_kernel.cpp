#include "bench/ray_kernel.h"

#include "bench/rays_shared.h"
#include "engine/core/check.h"
#include "engine/gpu/device.h"
#include "shaders/spirv.h"

namespace vamp {
namespace {

// What the traversal reads; the tree's own fetches, and the rays.
std::vector<gpu::Binding> ray_bindings(const TracePath& path) {
  using enum gpu::BindingType;
  std::vector<gpu::Binding> bindings = {
      {BINDING_PARAMS, storage_buffer},
      {BINDING_NODES, uniform_texel},
      {BINDING_BOXES, uniform_texel},
      {BINDING_TRIANGLES, uniform_texel},
      {BINDING_NODES_STORAGE, storage_buffer},
      {BINDING_BOXES_STORAGE, storage_buffer},
      {BINDING_TRIANGLES_STORAGE, storage_buffer},
      {BINDING_READY_RAYS, uniform_texel},
      {BINDING_FOUND, storage_buffer},
      {BINDING_FOUND_TRIANGLES, storage_buffer},
  };
  if (path.ray_queries) bindings.push_back({BINDING_RAYS, acceleration_structure});
  return bindings;
}

std::vector<gpu::Bound> bound_tables(const GpuTree& tree, const gpu::TexelView& rays, const gpu::Buffer& found,
                                     const gpu::Buffer& triangles) {
  const GpuScene& tables = tree.tables;
  std::vector<gpu::Bound> bound = {{BINDING_PARAMS, tables.params},
                                   {BINDING_NODES, tables.nodes.view},
                                   {BINDING_BOXES, tables.boxes.view},
                                   {BINDING_TRIANGLES, tables.triangles.view},
                                   {BINDING_NODES_STORAGE, tables.nodes.rows},
                                   {BINDING_BOXES_STORAGE, tables.boxes.rows},
                                   {BINDING_TRIANGLES_STORAGE, tables.triangles.rows},
                                   {BINDING_READY_RAYS, rays},
                                   {BINDING_FOUND, found},
                                   {BINDING_FOUND_TRIANGLES, triangles}};
  if (tree.path.ray_queries) bound.emplace_back(BINDING_RAYS, tables.rays);
  return bound;
}

}  // namespace

Result<GpuTree> GpuTree::make(gpu::Device& device, const Scene& scene, const TracePath& path) {
  GpuTree tree;
  const SceneTables tables = build_scene_tables(scene, std::vector<bool>(scene.parts.size(), true));
  tree.path = path;
  VAMP_TRY(const uint64_t bytes, tree.tables.send_scene(device, tables, path));
  static_cast<void>(bytes);
  frame::FrameParams params{};
  params.grid_origin = tables.bvh.grid_origin;
  params.grid_scale = tables.bvh.grid_scale;
  params.list_end = static_cast<uint32_t>(tables.bvh.list_end());
  tree.tables.params = gpu::TypedBuffer<frame::FrameParams>(device, "frame", 1);
  device.upload_rows<frame::FrameParams>(tree.tables.params, 0, std::span(&params, 1));
  return tree;
}

RayKernel::RayKernel(gpu::Device& device, const GpuTree& tree, RayQuestion question, std::span<const ReadyRay> rays)
    : device_(&device),
      invocations_(
          static_cast<uint32_t>(question == RayQuestion::nearest ? rays.size() : rays.size() / SAMPLES_PER_HIT)),
      rays_(device, "ready rays", rays.size(), gpu::Usage::uniform_texel),
      rays_view_(device, rays_, VK_FORMAT_R32G32B32A32_SFLOAT),
      found_(device, "found", rays.size()),
      triangles_(device, "found triangles", question == RayQuestion::nearest ? rays.size() : 0),
      pipeline_(device, {.name = "rays",
                         .spirv = tree.path.ray_queries ? spirv::rays_comp_ray_query() : spirv::rays_comp(),
                         .bindings = ray_bindings(tree.path),
                         .push_bytes = sizeof(frame::TilePush),
                         .constants = {{SPEC_NEAREST, question == RayQuestion::nearest},
                                       {SPEC_STORAGE_FETCH, tree.path.storage_fetch},
                                       {SPEC_SAMPLES, SAMPLES_PER_HIT},
                                       {SPEC_ALPHA_MASK, false}}}),
      set_(device, pipeline_, bound_tables(tree, rays_view_, found_, triangles_)) {
  CHECK(question == RayQuestion::nearest || rays.size() % SAMPLES_PER_HIT == 0);
  device.upload_rows<ReadyRay>(rays_, 0, rays);
  run();  // compiles
}

Times RayKernel::run() {
  const Stopwatch watch;
  gpu::CommandList list = device_->begin("rays");
  list.bind(pipeline_, set_);
  frame::TilePush push{};
  push.width = invocations_;
  list.push(push);
  list.dispatch((invocations_ + GROUP_SIZE - 1) / GROUP_SIZE);
  device_->wait(device_->submit(std::move(list)));
  return watch.stop();
}

std::vector<float> RayKernel::found() const {
  return device_->readback_rows<float>(found_, 0, found_.count(), device_->last_submitted());
}

std::vector<int> RayKernel::triangles() const {
  return device_->readback_rows<int>(triangles_, 0, triangles_.count(), device_->last_submitted());
}

}  // namespace vamp
