#include "engine/render/kernels.h"

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

std::span<const uint32_t> words_of(Pass pass) {
  switch (pass) {
    case Pass::trace:
      return spirv::trace_comp();
    case Pass::shade:
      return spirv::shade_comp();
    case Pass::composite:
      return spirv::composite_comp();
    case Pass::recombine:
      return spirv::recombine_comp();
    case Pass::aov:
      return spirv::aov_comp();
    case Pass::occlusion:
      return spirv::occlusion_comp();
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
    r.storage_fetch = !shows && key.storage_fetch;
    r.pixel_centres = pass == Pass::aov || (pass == Pass::occlusion && key.pixel_centres);
  }
  return r;
}

}  // namespace

const std::vector<gpu::Binding>& kernel_bindings() {
  using enum gpu::BindingType;
  static const std::vector<gpu::Binding> bindings = {
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
  return bindings;
}

const gpu::ComputePipeline& Kernels::get(Pass pass, KernelKey key) {
  key = reduced(pass, key);
  const auto found = pipelines_.find({pass, key});
  if (found != pipelines_.end()) return found->second;
  gpu::PipelineDesc desc;
  desc.name = name_of(pass);
  desc.spirv = pass == Pass::shade && !shade_.empty() ? shade_ : words_of(pass);
  desc.bindings = kernel_bindings();
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
                    {SPEC_STORAGE_FETCH, key.storage_fetch},
                    {SPEC_PIXEL_CENTRES, key.pixel_centres},
                    {SPEC_NEW_HIT, key.new_hit},
                    {SPEC_LIST, key.list},
                    {SPEC_HIGHLIGHT, key.highlight},
                    {SPEC_LIGHT_SLOTS, key.light_slots}};
  return pipelines_.emplace(std::pair(pass, key), gpu::ComputePipeline(*device_, desc)).first->second;
}

}  // namespace vamp
