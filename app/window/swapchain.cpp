#include "app/window/swapchain.h"

#include <algorithm>
#include <utility>

#include "engine/gpu/machine.h"

namespace vamp::window {

namespace {

VkSemaphore make_semaphore(gpu::Device& device) {
  const VkSemaphoreCreateInfo info{VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO, nullptr, 0};
  VkSemaphore semaphore = VK_NULL_HANDLE;
  gpu::require(vkCreateSemaphore(device.handle(), &info, nullptr, &semaphore), "window");
  return semaphore;
}

}  // namespace

Result<Swapchain> Swapchain::create(gpu::Device& device, VkSurfaceKHR surface) {
  Swapchain chain(device, surface);
  VkBool32 supported = VK_FALSE;
  gpu::require(vkGetPhysicalDeviceSurfaceSupportKHR(device.physical(), device.family(), surface, &supported),
               "window surface");
  uint32_t count = 0;
  vkGetPhysicalDeviceSurfaceFormatsKHR(device.physical(), surface, &count, nullptr);
  std::vector<VkSurfaceFormatKHR> formats(count);
  vkGetPhysicalDeviceSurfaceFormatsKHR(device.physical(), surface, &count, formats.data());
  const bool bgra = std::any_of(formats.begin(), formats.end(), [](const VkSurfaceFormatKHR& f) {
    return f.format == VK_FORMAT_B8G8R8A8_UNORM && f.colorSpace == VK_COLOR_SPACE_SRGB_NONLINEAR_KHR;
  });
  if (supported == VK_FALSE || !bgra) {
    return fail(ErrorKind::no_device, device.info().name, "window surface",
                "a device that presents 8-bit BGRA pictures to this display", supported ? "no such format" : "none");
  }
  count = 0;
  vkGetPhysicalDeviceSurfacePresentModesKHR(device.physical(), surface, &count, nullptr);
  std::vector<VkPresentModeKHR> modes(count);
  vkGetPhysicalDeviceSurfacePresentModesKHR(device.physical(), surface, &count, modes.data());
  // The queue belongs to the renderer: presenting must not wait for the screen where that can be had.
  for (const VkPresentModeKHR mode : {VK_PRESENT_MODE_IMMEDIATE_KHR, VK_PRESENT_MODE_MAILBOX_KHR}) {
    if (std::find(modes.begin(), modes.end(), mode) != modes.end()) chain.mode_ = mode;
  }
  return chain;
}

Swapchain::Swapchain(Swapchain&& other) noexcept
    : device_(other.device_),
      surface_(std::exchange(other.surface_, VK_NULL_HANDLE)),
      swapchain_(std::exchange(other.swapchain_, VK_NULL_HANDLE)),
      mode_(other.mode_),
      extent_(other.extent_),
      images_(std::move(other.images_)),
      drawn_(std::move(other.drawn_)),
      slots_(std::move(other.slots_)),
      slot_(other.slot_) {}

Swapchain::~Swapchain() {
  release_images();
  if (swapchain_ != VK_NULL_HANDLE) vkDestroySwapchainKHR(device_->handle(), swapchain_, nullptr);
  if (surface_ != VK_NULL_HANDLE) vkDestroySurfaceKHR(device_->instance(), surface_, nullptr);
}

void Swapchain::release_images() {
  if (images_.empty() && slots_.empty()) return;
  {
    // Presentation has no timeline value to wait for. The renderer has at most a tile in the queue.
    const std::lock_guard lock(device_->queue_mutex());
    vkQueueWaitIdle(device_->queue());
  }
  for (const VkSemaphore semaphore : drawn_) vkDestroySemaphore(device_->handle(), semaphore, nullptr);
  for (const Slot& slot : slots_) vkDestroySemaphore(device_->handle(), slot.acquired, nullptr);
  drawn_.clear();
  slots_.clear();
  images_.clear();
}

Result<bool> Swapchain::resize(uint32_t width, uint32_t height) {
  VkSurfaceCapabilitiesKHR can{};
  gpu::require(vkGetPhysicalDeviceSurfaceCapabilitiesKHR(device_->physical(), surface_, &can), "window surface");
  VkExtent2D extent = can.currentExtent;
  if (extent.width == UINT32_MAX) {
    extent.width = std::clamp(width, can.minImageExtent.width, can.maxImageExtent.width);
    extent.height = std::clamp(height, can.minImageExtent.height, can.maxImageExtent.height);
  }
  if (extent.width == 0 || extent.height == 0) return false;
  if ((can.supportedUsageFlags & VK_IMAGE_USAGE_TRANSFER_DST_BIT) == 0) {
    return fail(ErrorKind::no_device, device_->info().name, "window surface", "images that can be copied to", "none");
  }
  release_images();
  const VkSwapchainKHR old = swapchain_;
  VkSwapchainCreateInfoKHR info{VK_STRUCTURE_TYPE_SWAPCHAIN_CREATE_INFO_KHR};
  info.surface = surface_;
  info.minImageCount = std::max(can.minImageCount + 1, 3u);
  if (can.maxImageCount != 0) info.minImageCount = std::min(info.minImageCount, can.maxImageCount);
  info.imageFormat = format();
  info.imageColorSpace = VK_COLOR_SPACE_SRGB_NONLINEAR_KHR;
  info.imageExtent = extent;
  info.imageArrayLayers = 1;
  info.imageUsage = VK_IMAGE_USAGE_TRANSFER_DST_BIT | (can.supportedUsageFlags & VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT);
  info.imageSharingMode = VK_SHARING_MODE_EXCLUSIVE;
  info.preTransform = can.currentTransform;
  info.compositeAlpha = (can.supportedCompositeAlpha & VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR) != 0
                            ? VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR
                            : VK_COMPOSITE_ALPHA_INHERIT_BIT_KHR;
  info.presentMode = mode_;
  info.clipped = VK_TRUE;
  info.oldSwapchain = old;
  gpu::require(vkCreateSwapchainKHR(device_->handle(), &info, nullptr, &swapchain_), "presenting to the window");
  if (old != VK_NULL_HANDLE) vkDestroySwapchainKHR(device_->handle(), old, nullptr);
  extent_ = extent;
  uint32_t count = 0;
  vkGetSwapchainImagesKHR(device_->handle(), swapchain_, &count, nullptr);
  images_.resize(count);
  vkGetSwapchainImagesKHR(device_->handle(), swapchain_, &count, images_.data());
  for (size_t i = 0; i < images_.size(); ++i) drawn_.push_back(make_semaphore(*device_));
  for (size_t i = 0; i <= images_.size(); ++i) slots_.push_back({make_semaphore(*device_), 0});
  slot_ = 0;
  return true;
}

const char* Swapchain::mode() const {
  switch (mode_) {
    case VK_PRESENT_MODE_MAILBOX_KHR:
      return "mailbox";
    case VK_PRESENT_MODE_IMMEDIATE_KHR:
      return "immediate";
    default:
      return "fifo";
  }
}

Swapchain::Acquired Swapchain::acquire(uint32_t& index, gpu::SubmitSync& sync) {
  Slot& slot = slots_[slot_];
  if (slot.value != 0 && !device_->done(slot.value)) return Acquired::later;
  constexpr uint64_t kPatience = 10'000'000;  // ns
  const VkResult result =
      vkAcquireNextImageKHR(device_->handle(), swapchain_, kPatience, slot.acquired, VK_NULL_HANDLE, &index);
  if (result == VK_TIMEOUT || result == VK_NOT_READY) return Acquired::later;
  if (result == VK_ERROR_OUT_OF_DATE_KHR) return Acquired::outdated;
  gpu::require(result, "presenting to the window");
  sync.wait = slot.acquired;
  sync.wait_stage = VK_PIPELINE_STAGE_TRANSFER_BIT | VK_PIPELINE_STAGE_COLOR_ATTACHMENT_OUTPUT_BIT;
  sync.signal = drawn_[index];
  return Acquired::yes;
}

bool Swapchain::present(uint32_t index, uint64_t value) {
  slots_[slot_].value = value;
  slot_ = (slot_ + 1) % slots_.size();
  VkPresentInfoKHR info{VK_STRUCTURE_TYPE_PRESENT_INFO_KHR};
  info.waitSemaphoreCount = 1;
  info.pWaitSemaphores = &drawn_[index];
  info.swapchainCount = 1;
  info.pSwapchains = &swapchain_;
  info.pImageIndices = &index;
  VkResult result = VK_SUCCESS;
  {
    const std::lock_guard lock(device_->queue_mutex());
    result = vkQueuePresentKHR(device_->queue(), &info);
  }
  if (result == VK_ERROR_OUT_OF_DATE_KHR || result == VK_SUBOPTIMAL_KHR) return false;
  gpu::require(result, "presenting to the window");
  return true;
}

}  // namespace vamp::window
