#pragma once
// Boxes while a tree is made: exact ones, and the grid that they are rounded outwards to.
#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/accel/bvh_box.h"
#include "engine/scene/bounds.h"

namespace vamp {

// Four floats in one register; lane 3 is carried along and ignored.
using Lanes = float __attribute__((vector_size(16)));

inline Lanes lanes_min(Lanes a, Lanes b) { return a < b ? a : b; }
inline Lanes lanes_max(Lanes a, Lanes b) { return a > b ? a : b; }

struct ExactBox {
  Lanes lo, hi;

  static ExactBox empty() {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    return {Lanes{} + kInfinity, Lanes{} - kInfinity};
  }
  void extend(Lanes p) {
    lo = lanes_min(lo, p);
    hi = lanes_max(hi, p);
  }
  void extend(const ExactBox& b) {
    lo = lanes_min(lo, b.lo);
    hi = lanes_max(hi, b.hi);
  }
  float half_area() const {
    const Lanes s = hi - lo;
    return s[0] >= 0 ? s[0] * s[1] + s[1] * s[2] + s[2] * s[0] : 0.0f;
  }
  Bounds bounds() const { return {vec3(lo[0], lo[1], lo[2]), vec3(hi[0], hi[1], hi[2])}; }
};

// The 16-bit grid over the scene, with a cell to spare on each side.
class Grid {
 public:
  explicit Grid(const Bounds& bounds) {
    constexpr float kInfinity = std::numeric_limits<float>::infinity();
    const vec3 size = bounds.size();
    const double largest =
        std::max({static_cast<double>(size.x), static_cast<double>(size.y), static_cast<double>(size.z), 1e-20});
    for (int k = 0; k < 3; ++k) {
      // A flat scene still gets cells, small against what rays can resolve.
      const double extent = std::max(static_cast<double>(size[k]), largest * 1e-3);
      const double cell = extent / 65533.0;
      const double lo = static_cast<double>(bounds.lo[k]);
      origin[k] = std::nextafter(static_cast<float>(lo - cell), -kInfinity);
      const double span = std::max(lo + extent, static_cast<double>(bounds.hi[k])) - static_cast<double>(origin[k]);
      scale[k] = std::nextafter(static_cast<float>(span / 65533.0), kInfinity);
      inverse_[k] = 1.0 / static_cast<double>(scale[k]);
    }
  }

  // A quarter of a cell of margin on every side (see box_span()), and no more than it takes: a backdrop stretches the
  // grid until a cell is no longer small against a triangle, and then margins cost more than anything else in the tree.
  uvec4 child(const ExactBox& box, int32_t reference) const {
    constexpr double kMargin = 0.25;
    GridBox cells;
    for (int k = 0; k < 3; ++k) {
      const double lo = std::clamp(place(box.lo[k], k) - kMargin, 0.0, 65535.0);
      cells.lo[k] = static_cast<uint32_t>(static_cast<int32_t>(lo));
      // The kernels read the high side with the low one as its fraction.
      const double hi = place(box.hi[k], k) + kMargin - cells.lo[k] / 65536.0;
      cells.hi[k] = round_up(std::clamp(hi, 0.0, 65535.0));
    }
    return pack_box(cells, reference);
  }

  vec3 origin{0};
  vec3 scale{1};

 private:
  double place(float x, int k) const { return (static_cast<double>(x) - static_cast<double>(origin[k])) * inverse_[k]; }
  // std::ceil is a call where the compiler may not assume SSE 4.1, and takes most of a refit.
  static uint32_t round_up(double x) {
    const auto whole = static_cast<int32_t>(x);
    return static_cast<uint32_t>(whole) + (static_cast<double>(whole) < x ? 1u : 0u);
  }

  dvec3 inverse_{1};
};

}  // namespace vamp
