#pragma once
// The images of a window: made, made again when the window changes, acquired and presented.
#include <vulkan/vulkan.h>

#include <cstdint>
#include <vector>

#include "engine/core/error.h"
#include "engine/gpu/device.h"

namespace vamp::window {

class Swapchain {
 public:
  // Takes over the surface. Error: no_device when the device cannot present to it in a BGRA8 format.
  static Result<Swapchain> create(gpu::Device& device, VkSurfaceKHR surface);
  ~Swapchain();
  Swapchain(Swapchain&& other) noexcept;
  Swapchain& operator=(Swapchain&&) = delete;

  // Makes the images for a window of this size. False while there is nothing to present to (minimised).
  Result<bool> resize(uint32_t width, uint32_t height);

  VkFormat format() const { return VK_FORMAT_B8G8R8A8_UNORM; }
  VkExtent2D extent() const { return extent_; }
  size_t count() const { return images_.size(); }
  VkImage image(uint32_t index) const { return images_[index]; }
  const char* mode() const;  // of presentation, for the log

  enum class Acquired { yes, later, outdated };
  // An image to draw into, with the semaphores for the submit that draws. `later`: none is free just now.
  Acquired acquire(uint32_t& index, gpu::SubmitSync& sync);
  // Presents what was submitted as `value`; false when the images are outdated. Throws MachineError.
  bool present(uint32_t index, uint64_t value);

 private:
  Swapchain(gpu::Device& device, VkSurfaceKHR surface) : device_(&device), surface_(surface) {}
  void release_images();

  gpu::Device* device_;
  VkSurfaceKHR surface_ = VK_NULL_HANDLE;
  VkSwapchainKHR swapchain_ = VK_NULL_HANDLE;
  VkPresentModeKHR mode_ = VK_PRESENT_MODE_FIFO_KHR;
  VkExtent2D extent_{};
  std::vector<VkImage> images_;
  std::vector<VkSemaphore> drawn_;  // one an image
  struct Slot {
    VkSemaphore acquired = VK_NULL_HANDLE;
    uint64_t value = 0;  // of the submit that waits for it
  };
  std::vector<Slot> slots_;  // one more than images
  size_t slot_ = 0;
};

}  // namespace vamp::window
