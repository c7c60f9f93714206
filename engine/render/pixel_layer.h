#pragma once
#include <cstdint>
#include <vector>

namespace vamp {

// One value for each pixel, row 0 on top, with a number that grows whenever it changed.
struct PixelLayer {
  std::vector<uint32_t> pixels;  // empty: not known
  int width = 0, height = 0;
  uint64_t version = 0;
};

}  // namespace vamp
