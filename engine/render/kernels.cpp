#include "engine/render/kernels.h"

#include <algorithm>

#include "shaders/shared/frame.h"
#include "shaders/spirv.h"

namespace vamp {
namespace {

const char* name_of(Pass pass) {
  switch (pass) {
    case Pass::trace:
      return "trace";
    case Pass::shade:
      return "shade";
    case Pass::composite:
      return "composite";
    case Pass::recombine:
      return "recombine";
    case Pass::aov:
      return "aov";
    case Pass::occlusion:
      return "occlusion";
  }
  return "";
}

std::span<const uint32_t> words_of(Pass pass, const TracePath& path) {
  switch (pass) {
    case Pass::trace:
      return path.ray_queries ? spirv::trace_comp_ray_query() : spirv::trace_comp();
    case Pass::shade:
      return spirv::shade_comp();
    case Pass::composite:
      return spirv::composite_comp();
    case Pass::recombine:
      return spirv::recombine_comp();
    case Pass::aov:
      return path.ray_queries ? spirv::aov_comp_ray_query() : spirv::aov_comp();
    case Pass::occlusion:
      return path.ray_queries ? spirv::occlusion_comp_ray_query() : spirv::occlusion_comp();
  }
  return {};
}

// The constants that a pass reads, everything else at a fixed value.
KernelKey reduced(Pass pass, const KernelKey& key) {
  KernelKey r = key;
  const KernelKey none;
  if (pass != Pass::trace) r.new_hit = none.new_hit;
  if (pass == Pass::shade) r.alpha_mask = none.alpha_mask;
  if (pass == Pass::trace) {
    r.residual = none.residual;
    r.lobe_models = none.lobe_models;
    r.four_taps = none.four_taps;
  }
  const bool shows = pass == Pass::composite || pass == Pass::recombine;
  if (shows || pass == Pass::aov || pass == Pass::occlusion) {
    r = none;
    r.samples = pass == Pass::occlusion ? key.samples : 1;
    r.ambient = !shows || key.ambient;
    r.list = pass == Pass::recombine;
    r.alpha_mask = !shows && key.alpha_mask;
    // The bindings follow from it.
    r.path.ray_queries = key.path.ray_queries;
    r.path.storage_fetch = !shows && key.path.storage_fetch;
    r.pixel_centres = pass == Pass::aov || (pass == Pass::occlusion && key.pixel_centres);
  }
  return r;
}

}  // namespace

const std::vector<gpu::Binding>& kernel_bindings(const TracePath& path) {
  using enum gpu::BindingType;
  static const std::vector<gpu::Binding> own = {
      {BINDING_PARAMS, storage_buffer},
      {BINDING_LIGHTS, storage_buffer},
      {BINDING_NODES, uniform_texel},
      {BINDING_TRIANGLES, uniform_texel},
      {BINDING_NODES_STORAGE, storage_buffer},
      {BINDING_TRIANGLES_STORAGE, storage_buffer},
      {BINDING_SURFACE, uniform_texel},
      {BINDING_PARTS, uniform_texel},
      {BINDING_TEXELS, uniform_texel},
      {BINDING_ENTRIES, uniform_texel},
      {BINDING_BASES, uniform_texel},
      {BINDING_CLUSTERS, uniform_texel},
      {BINDING_RESIDUAL, uniform_texel},
      {BINDING_DIRECTION_TRIANGLES, uniform_texel},
      {BINDING_DIRECTION_MAP, uniform_texel},
      {BINDING_ENVIRONMENT, uniform_texel},
      {BINDING_ENVIRONMENT_CELLS, uniform_texel},
      {BINDING_ALPHA, uniform_texel},
      {BINDING_HITS, storage_texel},
      {BINDING_VISIBILITY, storage_texel},
      {BINDING_ACCUMULATORS, storage_texel},
      {BINDING_DISPLAY, storage_buffer},
      {BINDING_AOV, storage_texel},
      {BINDING_BOXES, uniform_texel},
      {BINDING_BOXES_STORAGE, storage_buffer},
      {BINDING_LIST, storage_buffer},
      {BINDING_SEEN, storage_texel},
      {BINDING_WHOLE, storage_texel},
      {BINDING_LIGHT_TEXELS, uniform_texel},
  };
  static const std::vector<gpu::Binding> queries = [] {
    std::vector<gpu::Binding> more = own;
    more.push_back({BINDING_RAYS, acceleration_structure});
    return more;
  }();
  return path.ray_queries ? queries : own;
}

gpu::PipelineDesc Kernels::describe(const Which& which) const {
  const auto& [pass, key] = which;
  gpu::PipelineDesc desc;
  desc.name = name_of(pass);
  desc.spirv = pass == Pass::shade && !shade_.empty() ? shade_ : words_of(pass, key.path);
  desc.bindings = kernel_bindings(key.path);
  desc.push_bytes = sizeof(frame::TilePush);
  desc.constants = {{SPEC_SAMPLES, key.samples},
                    {SPEC_LIGHT_COUNT, key.light_count},
                    {SPEC_LIGHT_TYPES, key.light_types},
                    {SPEC_AMBIENT, key.ambient},
                    {SPEC_ENVIRONMENT, key.environment},
                    {SPEC_MIRROR, key.mirror},
                    {SPEC_ALPHA_MASK, key.alpha_mask},
                    {SPEC_RESIDUAL, key.residual},
                    {SPEC_LOBE_MODELS, key.lobe_models},
                    {SPEC_FOUR_TAPS, key.four_taps},
                    {SPEC_STORAGE_FETCH, key.path.storage_fetch},
                    {SPEC_PIXEL_CENTRES, key.pixel_centres},
                    {SPEC_NEW_HIT, key.new_hit},
                    {SPEC_LIST, key.list},
                    {SPEC_HIGHLIGHT, key.highlight},
                    {SPEC_LIGHT_SLOTS, key.light_slots}};
  return desc;
}

void Kernels::make_in_background(std::function<void()> arrived) {
  if (gpu::BackgroundPipelines::useful(*device_))
    background_ = std::make_unique<gpu::BackgroundPipelines>(*device_, std::move(arrived));
}

void Kernels::bound_as(const std::vector<gpu::Binding>& bindings, const std::vector<gpu::Bound>& bound) {
  if (background_) background_->bound_as(bindings, bound);
}

const Kernels::Kernel* Kernels::find(const Which& which) const {
  const auto there = [&](const Which& w) {
    const auto at = kernels_.find(w);
    return at != kernels_.end() && at->second.pipeline ? &at->second : nullptr;
  };
  if (const Kernel* exact = there(which)) return exact;
  return same_bits() ? there({which.first, reduced(which.first, generic(which.second))}) : nullptr;
}

const gpu::ComputePipeline& Kernels::get(Pass pass, KernelKey key) {
  if (generic_alone_) key = generic(key);
  const Which which{pass, reduced(pass, key)};
  if (!background_) {
    Kernel& kernel = kernels_[which];
    if (!kernel.pipeline) kernel.pipeline = gpu::ComputePipeline(*device_, describe(which));
    return kernel.pipeline;
  }
  collect();
  const Kernel* found = find(which);
  if (found == nullptr) want(pass, key, Urgency::straight);
  for (; found == nullptr; found = find(which)) {
    background_->wait();
    collect();
  }
  return found->pipeline;
}

bool Kernels::ready(Pass pass, const KernelKey& key) const {
  return !background_ || find({pass, reduced(pass, key)}) != nullptr;
}

void Kernels::want(Pass pass, const KernelKey& key, Urgency urgency) {
  if (!background_) return;
  const Which which{pass, reduced(pass, key)};
  Kernel& kernel = kernels_[which];
  if (kernel.pipeline) return;
  auto number = static_cast<size_t>(std::find(asked_.begin(), asked_.end(), which) - asked_.begin());
  if (number == asked_.size()) asked_.push_back(which);
  // Asked for already: it may be in the making, or more urgent now.
  if (kernel.wanted)
    background_->raise(number, urgency);
  else
    background_->want(number, describe(which), urgency);
  kernel.wanted = true;
}

void Kernels::want_nothing() {
  if (!background_) return;
  for (const uint64_t number : background_->drop_wanted()) kernels_[asked_[number]].wanted = false;
}

void Kernels::collect() {
  if (!background_) return;
  for (auto& [number, pipeline] : background_->take()) kernels_[asked_[number]].pipeline = std::move(pipeline);
}

}  // namespace vamp
