#pragma once
// The pictures of the user interface as Vulkan images, uploaded when their revision changed.
#include <imgui.h>
#include <vulkan/vulkan.h>

#include <cstdint>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

#include "app/window/textures.h"
#include "engine/gpu/buffer.h"
#include "engine/gpu/device.h"

namespace vamp::window {

class VulkanTextures {
 public:
  VulkanTextures(gpu::Device& device, const Textures& textures);
  ~VulkanTextures();
  VulkanTextures(const VulkanTextures&) = delete;
  VulkanTextures& operator=(const VulkanTextures&) = delete;

  VkDescriptorSetLayout layout() const { return layout_; }

  // The set to bind for a texture; records its upload where it changed (outside of a render pass). VK_NULL_HANDLE when
  // it was removed.
  VkDescriptorSet prepare(gpu::CommandList& list, ImTextureID id);

  // Lets go of the images of removed textures.
  void sweep();

 private:
  struct Picture;
  void make(Picture& picture, const Texture& texture);
  void upload(gpu::CommandList& list, Picture& picture, const Texture& texture);
  void retire(Picture&& picture);
  VkDescriptorSet allocate_set();

  gpu::Device& device_;
  const Textures& textures_;
  VkSampler sampler_ = VK_NULL_HANDLE;
  VkDescriptorSetLayout layout_ = VK_NULL_HANDLE;
  std::vector<VkDescriptorPool> pools_;
  // Sets of retired pictures; whichever thread retires them puts them here.
  struct FreeSets {
    std::mutex mutex;
    std::vector<VkDescriptorSet> sets;
  };
  std::shared_ptr<FreeSets> free_sets_ = std::make_shared<FreeSets>();
  uint32_t left_in_pool_ = 0;
  std::map<ImTextureID, std::unique_ptr<Picture>> pictures_;
};

}  // namespace vamp::window
