#include "bench/ray_kernel.h"

#include "bench/rays_shared.h"
#include "engine/core/check.h"
#include "engine/gpu/device.h"
#include "engine/render/fetch_path.h"
#include "shaders/spirv.h"

namespace vamp {
namespace {

// What the traversal reads; the tree's own fetches, and the rays.
const std::vector<gpu::Binding>& ray_bindings() {
  using enum gpu::BindingType;
  static const std::vector<gpu::Binding> bindings = {
      {BINDING_PARAMS, storage_buffer},
      {BINDING_NODES, uniform_texel},
      {BINDING_BOXES, uniform_texel},
      {BINDING_TRIANGLES, uniform_texel},
      {BINDING_NODES_STORAGE, storage_buffer},
      {BINDING_BOXES_STORAGE, storage_buffer},
      {BINDING_TRIANGLES_STORAGE, storage_buffer},
      {BINDING_READY_RAYS, uniform_texel},
      {BINDING_FOUND, storage_buffer},
  };
  return bindings;
}

}  // namespace

Result<GpuTree> GpuTree::make(gpu::Device& device, const Scene& scene) {
  GpuTree tree;
  const SceneTables tables = build_scene_tables(scene, std::vector<bool>(scene.parts.size(), true));
  tree.storage_fetch = fetch_path(device.info()).storage;
  VAMP_TRY(const uint64_t bytes, tree.tables.send_scene(device, tables, tree.storage_fetch));
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
      pipeline_(device, {.name = "rays",
                         .spirv = spirv::rays_comp(),
                         .bindings = ray_bindings(),
                         .push_bytes = sizeof(frame::TilePush),
                         .constants = {{SPEC_NEAREST, question == RayQuestion::nearest},
                                       {SPEC_STORAGE_FETCH, tree.storage_fetch},
                                       {SPEC_SAMPLES, SAMPLES_PER_HIT},
                                       {SPEC_ALPHA_MASK, false}}}),
      set_(device, pipeline_,
           {{BINDING_PARAMS, tree.tables.params},
            {BINDING_NODES, tree.tables.nodes.view},
            {BINDING_BOXES, tree.tables.boxes.view},
            {BINDING_TRIANGLES, tree.tables.triangles.view},
            {BINDING_NODES_STORAGE, tree.tables.nodes.rows},
            {BINDING_BOXES_STORAGE, tree.tables.boxes.rows},
            {BINDING_TRIANGLES_STORAGE, tree.tables.triangles.rows},
            {BINDING_READY_RAYS, rays_view_},
            {BINDING_FOUND, found_}}) {
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

}  // namespace vamp
