#include "app/editor/outline.h"

#include <array>
#include <cstdlib>

#include "engine/core/check.h"

namespace vamp {
namespace {

struct Colour {
  uint8_t r, g, b, a;
};
constexpr Colour kAmber{245, 176, 52, 255};
constexpr Colour kRim{20, 20, 20, 150};
constexpr Colour kTint{245, 176, 52, 44};
constexpr Colour kWhite{255, 255, 255, 150};

// 1 where the pixel shows what is asked for.
std::vector<uint8_t> mask_of(std::span<const uint32_t> ids, const Outlined& wanted) {
  std::vector<uint8_t> mask(ids.size());
  const uint32_t part = static_cast<uint32_t>(wanted.part + 1), cluster = static_cast<uint32_t>(wanted.cluster + 1);
  for (size_t i = 0; i < ids.size(); ++i)
    mask[i] = (ids[i] & 0xffffu) == part && (wanted.cluster < 0 || ids[i] >> 16 == cluster) ? 1 : 0;
  return mask;
}

class Overlay {
 public:
  Overlay(int width, int height)
      : width_(width), height_(height), pixels_(4 * static_cast<size_t>(width) * static_cast<size_t>(height)) {}

  void put(int x, int y, Colour colour) {
    if (x < 0 || y < 0 || x >= width_ || y >= height_) return;
    uint8_t* p = &pixels_[4 * index(x, y)];
    p[0] = colour.r;
    p[1] = colour.g;
    p[2] = colour.b;
    p[3] = colour.a;
  }
  bool empty(int x, int y) const {
    return x >= 0 && y >= 0 && x < width_ && y < height_ && pixels_[4 * index(x, y) + 3] == 0;
  }

  // Whether a pixel is inside while one of its four neighbours is not; the picture's edge is no border.
  bool on_border(const std::vector<uint8_t>& mask, int x, int y) const {
    if (mask[index(x, y)] == 0) return false;
    return (x > 0 && mask[index(x - 1, y)] == 0) || (x + 1 < width_ && mask[index(x + 1, y)] == 0) ||
           (y > 0 && mask[index(x, y - 1)] == 0) || (y + 1 < height_ && mask[index(x, y + 1)] == 0);
  }

  void line(const std::vector<uint8_t>& mask, Colour colour, bool thick) {
    for (int y = 0; y < height_; ++y)
      for (int x = 0; x < width_; ++x) {
        if (!on_border(mask, x, y)) continue;
        put(x, y, colour);
        if (!thick) continue;
        put(x + 1, y, colour);
        put(x, y + 1, colour);
        put(x + 1, y + 1, colour);
      }
  }

  // A dark rim about everything drawn so far, so that the line shows on bright materials.
  void rim() {
    const std::vector<uint8_t> before = pixels_;
    for (int y = 0; y < height_; ++y)
      for (int x = 0; x < width_; ++x) {
        if (before[4 * index(x, y) + 3] != 255) continue;
        for (const auto& [dx, dy] : {std::array{-1, 0}, std::array{1, 0}, std::array{0, -1}, std::array{0, 1}})
          if (empty(x + dx, y + dy)) put(x + dx, y + dy, kRim);
      }
  }

  void tint(const std::vector<uint8_t>& mask) {
    for (int y = 0; y < height_; ++y)
      for (int x = 0; x < width_; ++x)
        if (mask[index(x, y)] != 0 && empty(x, y)) put(x, y, kTint);
  }

  std::vector<uint8_t> take() { return std::move(pixels_); }

 private:
  size_t index(int x, int y) const {
    return static_cast<size_t>(y) * static_cast<size_t>(width_) + static_cast<size_t>(x);
  }
  int width_, height_;
  std::vector<uint8_t> pixels_;
};

}  // namespace

std::vector<uint8_t> draw_outlines(std::span<const uint32_t> ids, int width, int height, const Outlined& selected,
                                   const Outlined& hovered) {
  CHECK(ids.size() == static_cast<size_t>(width) * static_cast<size_t>(height));
  Overlay overlay(width, height);
  if (selected.part >= 0) {
    overlay.line(mask_of(ids, {selected.part, -1}), kAmber, true);
    overlay.rim();
    if (selected.cluster >= 0) overlay.tint(mask_of(ids, selected));
  }
  if (hovered.part >= 0 && hovered.part != selected.part) overlay.line(mask_of(ids, {hovered.part, -1}), kWhite, false);
  return overlay.take();
}

}  // namespace vamp
