#include "engine/gpu/pipeline.h"

#include <algorithm>

#include "engine/core/check.h"
#include "engine/core/error.h"
#include "engine/gpu/acceleration_state.h"
#include "engine/gpu/acceleration_structure.h"
#include "engine/gpu/device.h"
#include "engine/gpu/machine.h"
#include "engine/gpu/pipeline_state.h"

namespace vamp::gpu {
namespace {

VkDescriptorType vulkan_type(BindingType type) {
  switch (type) {
    case BindingType::storage_buffer:
      return VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    case BindingType::uniform_buffer:
      return VK_DESCRIPTOR_TYPE_UNIFORM_BUFFER;
    case BindingType::uniform_texel:
      return VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER;
    case BindingType::storage_texel:
      return VK_DESCRIPTOR_TYPE_STORAGE_TEXEL_BUFFER;
    case BindingType::acceleration_structure:
      return VK_DESCRIPTOR_TYPE_ACCELERATION_STRUCTURE_KHR;
  }
  return VK_DESCRIPTOR_TYPE_MAX_ENUM;
}

Usage usage_for(BindingType type) {
  switch (type) {
    case BindingType::storage_buffer:
      return Usage::storage;
    case BindingType::uniform_buffer:
      return Usage::uniform;
    case BindingType::uniform_texel:
      return Usage::uniform_texel;
    case BindingType::storage_texel:
      return Usage::storage_texel;
    case BindingType::acceleration_structure:
      break;
  }
  return Usage::none;
}

}  // namespace

PipelineState::~PipelineState() {
  vkDestroyPipeline(device.handle(), pipeline, nullptr);
  vkDestroyPipelineLayout(device.handle(), layout, nullptr);
}

SetState::~SetState() { vkDestroyDescriptorPool(device.handle(), pool, nullptr); }

std::shared_ptr<SetLayout> Device::set_layout(std::vector<Binding> bindings) {
  std::sort(bindings.begin(), bindings.end());
  const std::scoped_lock lock(layouts_mutex_);
  auto& layout = layouts_[bindings];
  if (layout) return layout;
  std::vector<VkDescriptorSetLayoutBinding> vulkan;
  for (const auto& [binding, type] : bindings) {
    CHECK(vulkan.empty() || vulkan.back().binding != binding);
    vulkan.push_back({.binding = binding,
                      .descriptorType = vulkan_type(type),
                      .descriptorCount = 1,
                      .stageFlags = VK_SHADER_STAGE_COMPUTE_BIT});
  }
  const VkDescriptorSetLayoutCreateInfo info{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO,
                                             .bindingCount = static_cast<uint32_t>(vulkan.size()),
                                             .pBindings = vulkan.data()};
  auto made = std::make_shared<SetLayout>();
  made->bindings = std::move(bindings);
  require(vkCreateDescriptorSetLayout(device_, &info, nullptr, &made->layout), "GPU descriptor layout");
  layout = made;
  return made;
}

ComputePipeline::ComputePipeline(Device& device, const PipelineDesc& desc) {
  CHECK(!desc.spirv.empty() && desc.push_bytes % 4 == 0 && desc.push_bytes <= 128);
  auto state = std::make_shared<PipelineState>(device);
  const std::string what = "GPU kernel '" + desc.name + "'";
  state->name = desc.name;
  state->push_bytes = desc.push_bytes;
  state->set_layout = device.set_layout(desc.bindings);

  const VkPushConstantRange push{.stageFlags = VK_SHADER_STAGE_COMPUTE_BIT, .offset = 0, .size = desc.push_bytes};
  const VkPipelineLayoutCreateInfo layout{.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO,
                                          .setLayoutCount = 1,
                                          .pSetLayouts = &state->set_layout->layout,
                                          .pushConstantRangeCount = desc.push_bytes > 0 ? 1u : 0u,
                                          .pPushConstantRanges = &push};
  require(vkCreatePipelineLayout(device.handle(), &layout, nullptr, &state->layout), what);

  std::vector<VkSpecializationMapEntry> entries;
  std::vector<uint32_t> values;
  for (const SpecConstant& constant : desc.constants) {
    entries.push_back({constant.id, static_cast<uint32_t>(values.size() * sizeof(uint32_t)), sizeof(uint32_t)});
    values.push_back(constant.bits);
  }
  const VkSpecializationInfo special{.mapEntryCount = static_cast<uint32_t>(entries.size()),
                                     .pMapEntries = entries.data(),
                                     .dataSize = values.size() * sizeof(uint32_t),
                                     .pData = values.data()};
  const VkShaderModuleCreateInfo module_info{.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO,
                                             .codeSize = desc.spirv.size_bytes(),
                                             .pCode = desc.spirv.data()};
  VkShaderModule module = VK_NULL_HANDLE;
  require(vkCreateShaderModule(device.handle(), &module_info, nullptr, &module), what);
  const VkComputePipelineCreateInfo info{.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO,
                                         .stage = {.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO,
                                                   .stage = VK_SHADER_STAGE_COMPUTE_BIT,
                                                   .module = module,
                                                   .pName = "main",
                                                   .pSpecializationInfo = &special},
                                         .layout = state->layout};
  // No VkPipelineCache: lavapipe's is empty and GPU drivers keep a disk cache of their own.
  const VkResult result =
      vkCreateComputePipelines(device.handle(), VK_NULL_HANDLE, 1, &info, nullptr, &state->pipeline);
  vkDestroyShaderModule(device.handle(), module, nullptr);
  require(result, what);
  device.name_object(VK_OBJECT_TYPE_PIPELINE, reinterpret_cast<uint64_t>(state->pipeline), desc.name);
  state_ = std::move(state);
}

VkPipeline ComputePipeline::handle() const { return state_ ? state_->pipeline : VK_NULL_HANDLE; }
VkPipelineLayout ComputePipeline::layout() const { return state_ ? state_->layout : VK_NULL_HANDLE; }
const std::string& ComputePipeline::name() const {
  CHECK(state_);
  return state_->name;
}

DescriptorSet::DescriptorSet(Device& device, const ComputePipeline& pipeline, const std::vector<Bound>& bound)
    : DescriptorSet(device, pipeline.name(), pipeline.state()->set_layout->bindings, bound) {}

DescriptorSet::DescriptorSet(Device& device, const std::string& name, const std::vector<Binding>& bindings,
                             const std::vector<Bound>& bound) {
  auto state = std::make_shared<SetState>(device);
  const std::string what = "GPU descriptor set '" + name + "'";
  state->layout = device.set_layout(bindings);
  CHECK(bound.size() == state->layout->bindings.size());

  // A pool for each set: tens of them live at a time, and each goes on its own.
  std::vector<VkDescriptorPoolSize> sizes;
  for (const Binding& binding : state->layout->bindings) sizes.push_back({vulkan_type(binding.type), 1});
  if (sizes.empty()) sizes.push_back({VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, 1});
  const VkDescriptorPoolCreateInfo pool{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO,
                                        .maxSets = 1,
                                        .poolSizeCount = static_cast<uint32_t>(sizes.size()),
                                        .pPoolSizes = sizes.data()};
  require(vkCreateDescriptorPool(device.handle(), &pool, nullptr, &state->pool), what);
  const VkDescriptorSetAllocateInfo allocate{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO,
                                             .descriptorPool = state->pool,
                                             .descriptorSetCount = 1,
                                             .pSetLayouts = &state->layout->layout};
  require(vkAllocateDescriptorSets(device.handle(), &allocate, &state->set), what);
  device.name_object(VK_OBJECT_TYPE_DESCRIPTOR_SET, reinterpret_cast<uint64_t>(state->set), name);

  std::vector<VkDescriptorBufferInfo> buffers;
  std::vector<VkBufferView> views;
  std::vector<VkWriteDescriptorSetAccelerationStructureKHR> rays;
  std::vector<VkWriteDescriptorSet> writes;
  buffers.reserve(bound.size());  // the writes point into these
  views.reserve(bound.size());
  rays.reserve(bound.size());
  for (const Binding& binding : state->layout->bindings) {
    const auto found =
        std::find_if(bound.begin(), bound.end(), [&](const Bound& b) { return b.binding == binding.binding; });
    CHECK(found != bound.end());
    VkWriteDescriptorSet write{.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET,
                               .dstSet = state->set,
                               .dstBinding = binding.binding,
                               .descriptorCount = 1,
                               .descriptorType = vulkan_type(binding.type)};
    if (binding.type == BindingType::uniform_texel || binding.type == BindingType::storage_texel) {
      CHECK(found->view && *found->view);
      CHECK(has(found->view->state()->buffer->desc.usage, usage_for(binding.type)));
      views.push_back(found->view->handle());
      write.pTexelBufferView = &views.back();
      state->bound.push_back(found->view->state());
    } else if (binding.type == BindingType::acceleration_structure) {
      CHECK(found->rays && *found->rays);
      rays.push_back({.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET_ACCELERATION_STRUCTURE_KHR,
                      .accelerationStructureCount = 1,
                      .pAccelerationStructures = &found->rays->state()->top.handle});
      write.pNext = &rays.back();
      state->bound.push_back(found->rays->state());
    } else {
      CHECK(found->buffer && *found->buffer && has(found->buffer->usage(), usage_for(binding.type)));
      const Buffer& buffer = *found->buffer;
      CHECK(found->offset % device.info().storage_offset_alignment == 0 && found->offset <= buffer.bytes());
      const uint64_t rest = buffer.bytes() - found->offset;
      const uint64_t bytes = found->bytes == VK_WHOLE_SIZE ? rest : found->bytes;
      CHECK(bytes <= rest);
      if (auto fits = device.fits_storage_range(buffer.name(), bytes); !fits)
        throw MachineError(ErrorKind::device_lost, fits.error().message());
      // An empty range still needs some bytes: buffers are never smaller than 16.
      buffers.push_back(bytes > 0 ? VkDescriptorBufferInfo{buffer.handle(), found->offset, bytes}
                                  : VkDescriptorBufferInfo{buffer.handle(), 0, 16});
      write.pBufferInfo = &buffers.back();
      state->bound.push_back(buffer.state());
    }
    writes.push_back(write);
  }
  vkUpdateDescriptorSets(device.handle(), static_cast<uint32_t>(writes.size()), writes.data(), 0, nullptr);
  state_ = std::move(state);
}

VkDescriptorSet DescriptorSet::handle() const { return state_ ? state_->set : VK_NULL_HANDLE; }

}  // namespace vamp::gpu
