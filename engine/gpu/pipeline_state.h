#pragma once
// What pipelines and descriptor sets own.
#include <vulkan/vulkan.h>

#include <memory>
#include <string>
#include <vector>

#include "engine/gpu/pipeline.h"
#include "engine/gpu/resource.h"

namespace vamp::gpu {

// One per list of bindings and device; lives as long as the device.
struct SetLayout {
  std::vector<Binding> bindings;  // ascending
  VkDescriptorSetLayout layout = VK_NULL_HANDLE;
};

struct PipelineState final : Resource {
  using Resource::Resource;
  ~PipelineState() override;
  void mark_used(uint64_t) override {}

  std::string name;
  std::shared_ptr<SetLayout> set_layout;
  VkPipelineLayout layout = VK_NULL_HANDLE;
  VkPipeline pipeline = VK_NULL_HANDLE;
  uint32_t push_bytes = 0;
};

struct SetState final : Resource {
  using Resource::Resource;
  ~SetState() override;
  void mark_used(uint64_t value) override {
    for (const auto& resource : bound) resource->mark_used(value);
  }

  std::shared_ptr<SetLayout> layout;
  VkDescriptorPool pool = VK_NULL_HANDLE;
  VkDescriptorSet set = VK_NULL_HANDLE;
  std::vector<std::shared_ptr<Resource>> bound;
};

}  // namespace vamp::gpu
