#pragma once

namespace vamp {

// A rectangle of the picture, pixels, row 0 on top.
struct Region {
  int x = 0, y = 0, width = 0, height = 0;
  bool operator==(const Region&) const = default;
};

}  // namespace vamp
