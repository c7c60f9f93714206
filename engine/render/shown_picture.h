#pragma once
// What a session shows of its work: the picture, what each pixel is of, and which pixels the last edit restarted.
// Written by the render thread, read by any.
#include <atomic>
#include <cstdint>
#include <memory>
#include <mutex>
#include <vector>

#include "engine/project/project.h"
#include "engine/render/pixel_layer.h"
#include "engine/render/renderer.h"

namespace vamp {

// What a picture is of.
struct Drawn {
  std::shared_ptr<const Project> project;  // null: nothing yet
  std::shared_ptr<const SceneTables> tables;
  std::vector<frame::PartRow> rows;
  int width = 0, height = 0;
};

class ShownPicture {
 public:
  // --- For readers. A layer is copied if it is newer than the one given.
  uint64_t version() const { return version_.load(std::memory_order_acquire); }
  bool copy_picture(PixelLayer& layer) const { return copy(picture_, layer); }
  bool copy_ids(PixelLayer& layer) const { return copy(ids_, layer); }
  bool copy_restarted(PixelLayer& layer) const { return copy(restarted_, layer); }

  Drawn drawn() const;

  // --- For the render thread.
  void draw(std::shared_ptr<const Project> project, const Renderer& renderer);
  // A new size: dark until something is shown, and nobody knows what is where.
  void resize(int width, int height);
  // Copies a tile, or all, of what the renderer displays after a timeline value.
  void show_tile(Renderer& renderer, int tile, uint64_t value);
  void show_all(Renderer& renderer, uint64_t value);
  // What was drawn from them would stand where things were.
  void forget_ids();
  // What each pixel's centre is of, from layers drawn until `value`; returns the share of pixels that show the model.
  double read_ids(Renderer& renderer, uint64_t value);
  // 1 for each of these pixels, 0 for the others; all of them.
  void set_restarted(const std::vector<uint32_t>& pixels);
  void set_all_restarted();

 private:
  bool copy(const PixelLayer& from, PixelLayer& to) const;
  void replace(PixelLayer& layer, std::vector<uint32_t> pixels);

  mutable std::mutex mutex_;
  PixelLayer picture_, ids_, restarted_;
  std::atomic<uint64_t> version_{0};  // of the picture
  Drawn drawn_;
};

}  // namespace vamp
