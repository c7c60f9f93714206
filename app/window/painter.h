#pragma once
// What turns ImGui's output into the window's image: the CPU rasteriser, or Vulkan's graphics pipeline on a GPU.
#include <vulkan/vulkan.h>

#include <cstdint>
#include <memory>
#include <span>

struct GLFWwindow;
struct ImDrawData;

namespace vamp::gpu {
class CommandList;
class Device;
}  // namespace vamp::gpu

namespace vamp::window {

class Textures;

class Painter {
 public:
  virtual ~Painter() = default;

  // For images of this size from now on. False where it has nothing to paint into any more.
  virtual bool resize(uint32_t width, uint32_t height, std::span<const VkImage> images) = 0;

  // Takes over a frame. False when the window would show what it shows already.
  virtual bool prepare(const ImDrawData& data) = 0;

  // Whether prepare() has shown the frame; then there are no images and nothing is recorded.
  virtual bool shows_itself() const { return false; }

  // Records the drawing of the frame into an acquired image, from any layout to presentation.
  virtual void record(gpu::CommandList& list, VkImage image, uint32_t index) = 0;

  // The recording was submitted as this timeline value.
  virtual void submitted(uint64_t value) = 0;

  // Must draw even where nothing changed (new images, an exposed window).
  virtual void forget() = 0;

  virtual const char* name() const = 0;
};

// Into memory that an X server shares with the program; null where there is no such.
std::unique_ptr<Painter> make_shared_painter(GLFWwindow* window, const Textures& textures);
std::unique_ptr<Painter> make_cpu_painter(gpu::Device& device, const Textures& textures);
std::unique_ptr<Painter> make_vulkan_painter(gpu::Device& device, const Textures& textures);

}  // namespace vamp::window
