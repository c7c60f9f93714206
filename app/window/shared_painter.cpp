// The user interface drawn on the CPU straight into the memory of an X window.
#include <imgui.h>

#include "app/window/cpu_rasteriser.h"
#include "app/window/painter.h"
#include "app/window/shared_window.h"

namespace vamp::window {
namespace {

class SharedPainter final : public Painter {
 public:
  SharedPainter(std::unique_ptr<SharedWindow> window, const Textures& textures)
      : window_(std::move(window)), raster_(textures) {}

  bool resize(uint32_t width, uint32_t height, std::span<const VkImage>) override {
    raster_.forget();
    return window_->resize(static_cast<int>(width), static_cast<int>(height));
  }

  bool prepare(const ImDrawData& data) override {
    const std::span<const PixelRect> changed = raster_.draw(data, window_->canvas());
    if (!changed.empty()) window_->put(changed);
    return !changed.empty();
  }

  bool shows_itself() const override { return true; }
  void record(gpu::CommandList&, VkImage, uint32_t) override {}
  void submitted(uint64_t) override {}
  void forget() override { raster_.forget(); }
  const char* name() const override { return "CPU"; }

 private:
  std::unique_ptr<SharedWindow> window_;
  CpuRasteriser raster_;
};

}  // namespace

std::unique_ptr<Painter> make_shared_painter(GLFWwindow* window, const Textures& textures) {
  auto shared = SharedWindow::open(window);
  return shared ? std::make_unique<SharedPainter>(std::move(shared), textures) : nullptr;
}

}  // namespace vamp::window
