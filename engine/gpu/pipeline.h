#pragma once
// Compute pipelines and the descriptor sets that feed them.
#include <vulkan/vulkan.h>

#include <bit>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "engine/gpu/buffer.h"

namespace vamp::gpu {

class AccelerationStructure;
class Device;
struct PipelineState;
struct SetState;
struct SetLayout;

enum class BindingType { storage_buffer, uniform_buffer, uniform_texel, storage_texel, acceleration_structure };

// layout(set = 0, binding = N) of a kernel.
struct Binding {
  uint32_t binding = 0;
  BindingType type = BindingType::storage_buffer;
  auto operator<=>(const Binding&) const = default;
};

// layout(constant_id = N) of a kernel.
struct SpecConstant {
  SpecConstant(uint32_t id_, uint32_t value) : id(id_), bits(value) {}
  SpecConstant(uint32_t id_, int32_t value) : id(id_), bits(static_cast<uint32_t>(value)) {}
  SpecConstant(uint32_t id_, float value) : id(id_), bits(std::bit_cast<uint32_t>(value)) {}
  SpecConstant(uint32_t id_, bool value) : id(id_), bits(value ? 1u : 0u) {}
  uint32_t id;
  uint32_t bits;
};

struct PipelineDesc {
  std::string name;
  std::span<const uint32_t> spirv;  // read during construction only
  std::vector<Binding> bindings;    // all of set 0
  uint32_t push_bytes = 0;          // a multiple of 4, at most 128
  std::vector<SpecConstant> constants;
};

// One kernel, specialised. May be made on any thread. lavapipe compiles at the first dispatch, not here: to compile in
// the background, dispatch once on a Device::sibling(), whose result the driver's disk cache keeps.
class ComputePipeline {
 public:
  ComputePipeline() = default;
  // Throws MachineError when the driver refuses.
  ComputePipeline(Device& device, const PipelineDesc& desc);

  explicit operator bool() const { return state_ != nullptr; }
  VkPipeline handle() const;
  VkPipelineLayout layout() const;
  const std::string& name() const;
  const std::shared_ptr<PipelineState>& state() const { return state_; }

  ComputePipeline(ComputePipeline&&) noexcept = default;
  ComputePipeline& operator=(ComputePipeline&&) noexcept = default;

 private:
  std::shared_ptr<PipelineState> state_;
};

// What stands at one binding: a buffer (or a part of it), a texel view or an acceleration structure.
struct Bound {
  Bound(uint32_t binding_, const Buffer& buffer_, uint64_t offset_ = 0, uint64_t bytes_ = VK_WHOLE_SIZE)
      : binding(binding_), buffer(&buffer_), offset(offset_), bytes(bytes_) {}
  Bound(uint32_t binding_, const TexelView& view_) : binding(binding_), view(&view_) {}
  Bound(uint32_t binding_, const AccelerationStructure& rays_) : binding(binding_), rays(&rays_) {}
  uint32_t binding;
  const Buffer* buffer = nullptr;
  const TexelView* view = nullptr;
  const AccelerationStructure* rays = nullptr;
  uint64_t offset = 0;  // bytes
  uint64_t bytes = VK_WHOLE_SIZE;
};

// Everything that a kernel reads and writes; fixed once made, so make a new one when a buffer is replaced. Serves every
// pipeline with the same bindings as the one it was made for. Keeps its buffers alive.
class DescriptorSet {
 public:
  DescriptorSet() = default;
  // `bound` names each binding of the pipeline once. Throws MachineError when a storage range is larger than the device
  // allows; Device::fits_storage_range asks first.
  DescriptorSet(Device& device, const ComputePipeline& pipeline, const std::vector<Bound>& bound);
  // For pipelines that are yet to be made.
  DescriptorSet(Device& device, const std::string& name, const std::vector<Binding>& bindings,
                const std::vector<Bound>& bound);

  explicit operator bool() const { return state_ != nullptr; }
  VkDescriptorSet handle() const;
  const std::shared_ptr<SetState>& state() const { return state_; }

  DescriptorSet(DescriptorSet&&) noexcept = default;
  DescriptorSet& operator=(DescriptorSet&&) noexcept = default;

 private:
  std::shared_ptr<SetState> state_;
};

}  // namespace vamp::gpu
