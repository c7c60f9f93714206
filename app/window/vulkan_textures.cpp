#include "app/window/vulkan_textures.h"

#include <cstring>
#include <utility>

#include "engine/gpu/machine.h"

namespace vamp::window {

using gpu::require;

namespace {

constexpr uint32_t kSetsInPool = 64;

VkFormat format_of(const Texture& texture) {
  switch (texture.format) {
    case PixelFormat::alpha8:
      return VK_FORMAT_R8_UNORM;
    case PixelFormat::bgra8:
      return VK_FORMAT_B8G8R8A8_UNORM;
    case PixelFormat::rgba8:
      break;
  }
  return VK_FORMAT_R8G8B8A8_UNORM;
}

VkComponentMapping mapping_of(const Texture& texture) {
  if (texture.format == PixelFormat::alpha8) {
    return {VK_COMPONENT_SWIZZLE_ONE, VK_COMPONENT_SWIZZLE_ONE, VK_COMPONENT_SWIZZLE_ONE, VK_COMPONENT_SWIZZLE_R};
  }
  VkComponentMapping mapping{};
  if (texture.opaque) mapping.a = VK_COMPONENT_SWIZZLE_ONE;
  return mapping;
}

}  // namespace

struct VulkanTextures::Picture {
  VkImage image = VK_NULL_HANDLE;
  VkDeviceMemory memory = VK_NULL_HANDLE;
  VkImageView view = VK_NULL_HANDLE;
  VkDescriptorSet set = VK_NULL_HANDLE;
  int width = 0;
  int height = 0;
  PixelFormat format = PixelFormat::rgba8;
  bool opaque = false;
  uint64_t revision = 0;
};

VulkanTextures::VulkanTextures(gpu::Device& device, const Textures& textures) : device_(device), textures_(textures) {
  VkSamplerCreateInfo sampler{VK_STRUCTURE_TYPE_SAMPLER_CREATE_INFO};
  sampler.magFilter = sampler.minFilter = VK_FILTER_LINEAR;
  sampler.addressModeU = sampler.addressModeV = sampler.addressModeW = VK_SAMPLER_ADDRESS_MODE_CLAMP_TO_EDGE;
  require(vkCreateSampler(device.handle(), &sampler, nullptr, &sampler_), "user interface sampler");
  VkDescriptorSetLayoutBinding binding{};
  binding.descriptorType = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
  binding.descriptorCount = 1;
  binding.stageFlags = VK_SHADER_STAGE_FRAGMENT_BIT;
  binding.pImmutableSamplers = &sampler_;
  VkDescriptorSetLayoutCreateInfo layout{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
  layout.bindingCount = 1;
  layout.pBindings = &binding;
  require(vkCreateDescriptorSetLayout(device.handle(), &layout, nullptr, &layout_), "user interface layout");
}

VulkanTextures::~VulkanTextures() {
  device_.wait(device_.last_submitted());
  for (auto& [id, picture] : pictures_) {
    vkDestroyImageView(device_.handle(), picture->view, nullptr);
    vkDestroyImage(device_.handle(), picture->image, nullptr);
    vkFreeMemory(device_.handle(), picture->memory, nullptr);
  }
  for (const VkDescriptorPool pool : pools_) vkDestroyDescriptorPool(device_.handle(), pool, nullptr);
  vkDestroyDescriptorSetLayout(device_.handle(), layout_, nullptr);
  vkDestroySampler(device_.handle(), sampler_, nullptr);
}

VkDescriptorSet VulkanTextures::allocate_set() {
  {
    const std::lock_guard lock(free_sets_->mutex);
    if (!free_sets_->sets.empty()) {
      const VkDescriptorSet set = free_sets_->sets.back();
      free_sets_->sets.pop_back();
      return set;
    }
  }
  if (left_in_pool_ == 0) {
    const VkDescriptorPoolSize size{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, kSetsInPool};
    VkDescriptorPoolCreateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
    info.maxSets = kSetsInPool;
    info.poolSizeCount = 1;
    info.pPoolSizes = &size;
    VkDescriptorPool pool = VK_NULL_HANDLE;
    require(vkCreateDescriptorPool(device_.handle(), &info, nullptr, &pool), "user interface pictures");
    pools_.push_back(pool);
    left_in_pool_ = kSetsInPool;
  }
  --left_in_pool_;
  VkDescriptorSetAllocateInfo info{VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
  info.descriptorPool = pools_.back();
  info.descriptorSetCount = 1;
  info.pSetLayouts = &layout_;
  VkDescriptorSet set = VK_NULL_HANDLE;
  require(vkAllocateDescriptorSets(device_.handle(), &info, &set), "user interface pictures");
  return set;
}

void VulkanTextures::make(Picture& picture, const Texture& texture) {
  picture.width = texture.width;
  picture.height = texture.height;
  picture.format = texture.format;
  picture.opaque = texture.opaque;
  VkImageCreateInfo image{VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
  image.imageType = VK_IMAGE_TYPE_2D;
  image.format = format_of(texture);
  image.extent = {static_cast<uint32_t>(texture.width), static_cast<uint32_t>(texture.height), 1};
  image.mipLevels = image.arrayLayers = 1;
  image.samples = VK_SAMPLE_COUNT_1_BIT;
  image.usage = VK_IMAGE_USAGE_SAMPLED_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
  require(vkCreateImage(device_.handle(), &image, nullptr, &picture.image), "user interface picture");
  VkMemoryRequirements needed{};
  vkGetImageMemoryRequirements(device_.handle(), picture.image, &needed);
  VkPhysicalDeviceMemoryProperties memory{};
  vkGetPhysicalDeviceMemoryProperties(device_.physical(), &memory);
  uint32_t type = 0;
  for (uint32_t i = memory.memoryTypeCount; i-- > 0;) {
    const bool allowed = (needed.memoryTypeBits >> i & 1u) != 0;
    const bool local = (memory.memoryTypes[i].propertyFlags & VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT) != 0;
    if (allowed && local) type = i;
  }
  VkMemoryAllocateInfo allocation{VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
  allocation.allocationSize = needed.size;
  allocation.memoryTypeIndex = type;
  require(vkAllocateMemory(device_.handle(), &allocation, nullptr, &picture.memory), "user interface picture");
  require(vkBindImageMemory(device_.handle(), picture.image, picture.memory, 0), "user interface picture");
  VkImageViewCreateInfo view{VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
  view.image = picture.image;
  view.viewType = VK_IMAGE_VIEW_TYPE_2D;
  view.format = image.format;
  view.components = mapping_of(texture);
  view.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
  require(vkCreateImageView(device_.handle(), &view, nullptr, &picture.view), "user interface picture");
  picture.set = allocate_set();
  const VkDescriptorImageInfo shown{VK_NULL_HANDLE, picture.view, VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL};
  VkWriteDescriptorSet write{VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
  write.dstSet = picture.set;
  write.descriptorCount = 1;
  write.descriptorType = VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER;
  write.pImageInfo = &shown;
  vkUpdateDescriptorSets(device_.handle(), 1, &write, 0, nullptr);
}

void VulkanTextures::upload(gpu::CommandList& list, Picture& picture, const Texture& texture) {
  const size_t row = static_cast<size_t>(texture.width) * bytes_per_pixel(texture.format);
  const gpu::Buffer staging(device_, {"user interface picture", row * static_cast<size_t>(texture.height),
                                      gpu::Usage::none, gpu::Memory::upload});
  for (int y = 0; y < texture.height; ++y) {
    std::memcpy(staging.mapped() + static_cast<size_t>(y) * row,
                texture.pixels + static_cast<size_t>(y) * texture.row_bytes, row);
  }
  list.use(staging);
  VkImageMemoryBarrier barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER};
  barrier.dstAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT;
  barrier.newLayout = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;
  barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  barrier.image = picture.image;
  barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
  vkCmdPipelineBarrier(list.handle(), VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT, VK_PIPELINE_STAGE_TRANSFER_BIT, 0, 0,
                       nullptr, 0, nullptr, 1, &barrier);
  VkBufferImageCopy region{};
  region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
  region.imageExtent = {static_cast<uint32_t>(texture.width), static_cast<uint32_t>(texture.height), 1};
  vkCmdCopyBufferToImage(list.handle(), staging.handle(), picture.image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1,
                         &region);
  barrier.srcAccessMask = VK_ACCESS_TRANSFER_WRITE_BIT;
  barrier.dstAccessMask = VK_ACCESS_SHADER_READ_BIT;
  barrier.oldLayout = VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL;
  barrier.newLayout = VK_IMAGE_LAYOUT_SHADER_READ_ONLY_OPTIMAL;
  vkCmdPipelineBarrier(list.handle(), VK_PIPELINE_STAGE_TRANSFER_BIT, VK_PIPELINE_STAGE_FRAGMENT_SHADER_BIT, 0, 0,
                       nullptr, 0, nullptr, 1, &barrier);
  picture.revision = texture.revision;
}

void VulkanTextures::retire(Picture&& picture) {
  device_.retire([free = free_sets_, set = picture.set, device = device_.handle(), view = picture.view,
                  image = picture.image, memory = picture.memory] {
    const std::lock_guard lock(free->mutex);
    free->sets.push_back(set);
    vkDestroyImageView(device, view, nullptr);
    vkDestroyImage(device, image, nullptr);
    vkFreeMemory(device, memory, nullptr);
  });
}

VkDescriptorSet VulkanTextures::prepare(gpu::CommandList& list, ImTextureID id) {
  const Texture* texture = textures_.find(id);
  if (texture == nullptr || texture->pixels == nullptr) return VK_NULL_HANDLE;
  std::unique_ptr<Picture>& picture = pictures_[id];
  if (picture && (picture->width != texture->width || picture->height != texture->height ||
                  picture->format != texture->format || picture->opaque != texture->opaque)) {
    // The set may still be in use by a frame in flight: a new one takes its place.
    retire(std::move(*picture));
    picture.reset();
  }
  if (!picture) {
    picture = std::make_unique<Picture>();
    make(*picture, *texture);
  }
  if (picture->revision != texture->revision) upload(list, *picture, *texture);
  return picture->set;
}

void VulkanTextures::sweep() {
  for (auto it = pictures_.begin(); it != pictures_.end();) {
    if (textures_.find(it->first) == nullptr) {
      retire(std::move(*it->second));
      it = pictures_.erase(it);
    } else {
      ++it;
    }
  }
}

}  // namespace vamp::window
