#pragma once
// Draws ImGui's output into a BGRA8 image on the CPU. Where Vulkan itself runs on the CPU this costs a tenth of the
// graphics pipeline and leaves the queue to the renderer. Only tiles whose content changed are drawn again.
#include <cstdint>
#include <span>
#include <vector>

#include "app/window/textures.h"

namespace vamp::window {

struct PixelRect {
  int x0 = 0;
  int y0 = 0;
  int x1 = 0;  // one past the last
  int y1 = 0;
  friend bool operator==(const PixelRect&, const PixelRect&) = default;
};

// A BGRA8 image in memory; the alpha of every drawn pixel becomes 255.
struct Canvas {
  uint32_t* pixels = nullptr;
  int width = 0;
  int height = 0;
  size_t row_pixels = 0;
};

class CpuRasteriser {
 public:
  static constexpr int kTile = 64;

  explicit CpuRasteriser(const Textures& textures) : textures_(textures) {}

  // What shows where nothing is drawn, 0xRRGGBB.
  void set_background(uint32_t rgb);

  // Draws what differs from the last call and returns the changed rectangles (none: the canvas is as it was). The
  // canvas must still hold what the last call left in it; after a change of its size or memory everything is drawn.
  // Covers a pixel when its centre is inside, with the top-left rule for shared edges; blends encoded values, as the
  // graphics pipeline does on a UNORM target.
  std::span<const PixelRect> draw(const ImDrawData& data, const Canvas& canvas);

  // The next draw() paints everything.
  void forget() { hashes_.clear(); }

  struct Primitive {
    enum class Kind : uint8_t { solid, picture, triangle } kind;
    PixelRect bounds;  // covered pixels at most, already clipped
    const Texture* texture;
    const ImDrawVert* v[3];  // solid, picture: v[0] top left, v[1] bottom right
  };

 private:
  void collect(const ImDrawData& data, const Canvas& canvas);
  void enter_command(const ImDrawList& list, const ImDrawCmd& command, const PixelRect& clip, const Texture& texture);
  void enter(const Primitive& primitive, uint64_t hash);

  const Textures& textures_;
  uint32_t background_ = 0xff000000;
  Canvas last_;
  int columns_ = 0;
  int rows_ = 0;
  std::vector<Primitive> primitives_;
  std::vector<std::vector<uint32_t>> tiles_;  // primitives that touch the tile, in drawing order
  std::vector<uint64_t> hashes_;              // of what each tile shows now
  std::vector<uint64_t> next_hashes_;
  std::vector<PixelRect> changed_;
};

}  // namespace vamp::window
