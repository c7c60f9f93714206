// The user interface drawn on the CPU into one persistent BGRA8 buffer, which is copied whole to the window's image.
#include <imgui.h>

#include "app/window/cpu_rasteriser.h"
#include "app/window/painter.h"
#include "engine/gpu/device.h"

namespace vamp::window {

namespace {

void change_layout(VkCommandBuffer commands, VkImage image, VkImageLayout from, VkImageLayout to, VkAccessFlags before,
                   VkAccessFlags after, VkPipelineStageFlags first, VkPipelineStageFlags then) {
  VkImageMemoryBarrier barrier{VK_STRUCTURE_TYPE_IMAGE_MEMORY_BARRIER};
  barrier.srcAccessMask = before;
  barrier.dstAccessMask = after;
  barrier.oldLayout = from;
  barrier.newLayout = to;
  barrier.srcQueueFamilyIndex = barrier.dstQueueFamilyIndex = VK_QUEUE_FAMILY_IGNORED;
  barrier.image = image;
  barrier.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
  vkCmdPipelineBarrier(commands, first, then, 0, 0, nullptr, 0, nullptr, 1, &barrier);
}

class CpuPainter final : public Painter {
 public:
  CpuPainter(gpu::Device& device, const Textures& textures) : device_(device), raster_(textures) {}

  bool resize(uint32_t width, uint32_t height, std::span<const VkImage>) override {
    width_ = width;
    height_ = height;
    const uint64_t pixels = uint64_t{width} * height;
    if (pixels > buffer_.count()) {
      buffer_ = gpu::TypedBuffer<uint32_t>(device_, "user interface", pixels, gpu::Usage::none, gpu::Memory::readback);
    }
    value_ = 0;
    raster_.forget();
    return true;
  }

  bool prepare(const ImDrawData& data) override {
    if (width_ == 0) return false;
    // The last copy out of the buffer must be over; it usually is since long.
    if (value_ != 0) device_.wait(value_);
    const Canvas canvas{buffer_.mapped_rows().data(), static_cast<int>(width_), static_cast<int>(height_), width_};
    return !raster_.draw(data, canvas).empty();
  }

  void record(gpu::CommandList& list, VkImage image, uint32_t) override {
    change_layout(list.handle(), image, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 0,
                  VK_ACCESS_TRANSFER_WRITE_BIT, VK_PIPELINE_STAGE_TRANSFER_BIT, VK_PIPELINE_STAGE_TRANSFER_BIT);
    VkBufferImageCopy region{};
    region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
    region.imageExtent = {width_, height_, 1};
    list.use(buffer_);
    vkCmdCopyBufferToImage(list.handle(), buffer_.handle(), image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region);
    change_layout(list.handle(), image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, VK_IMAGE_LAYOUT_PRESENT_SRC_KHR,
                  VK_ACCESS_TRANSFER_WRITE_BIT, 0, VK_PIPELINE_STAGE_TRANSFER_BIT,
                  VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT);
  }

  void submitted(uint64_t value) override { value_ = value; }
  void forget() override { raster_.forget(); }
  const char* name() const override { return "CPU"; }

 private:
  gpu::Device& device_;
  CpuRasteriser raster_;
  gpu::TypedBuffer<uint32_t> buffer_;
  uint32_t width_ = 0;
  uint32_t height_ = 0;
  uint64_t value_ = 0;  // of the last copy
};

}  // namespace

std::unique_ptr<Painter> make_cpu_painter(gpu::Device& device, const Textures& textures) {
  return std::make_unique<CpuPainter>(device, textures);
}

}  // namespace vamp::window
