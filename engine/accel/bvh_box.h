#pragma once
// The boxes of the tree on their grid, as shaders/shared/intersect.h packs them.
#include <cstdint>

#include "engine/core/vec.h"

namespace vamp {

struct GridBox {
  uvec3 lo{0}, hi{0};  // 0 to 65535
};

inline uvec4 pack_box(const GridBox& box, int32_t inside) {
  const auto word = [](uint32_t lo, uint32_t hi) { return lo | (hi ^ 0x8000u) << 16; };
  return uvec4(word(box.lo.x, box.hi.x), word(box.lo.y, box.hi.y), word(box.lo.z, box.hi.z),
               static_cast<uint32_t>(inside));
}

inline GridBox unpack_box(const uvec4& packed) { return {uvec3(packed) & 0xffffu, (uvec3(packed) >> 16u) ^ 0x8000u}; }

// Half its surface, square scene units.
inline double half_area(const uvec4& packed, const vec3& grid_scale) {
  const GridBox box = unpack_box(packed);
  const auto size = [&](int axis) {
    return (static_cast<double>(box.hi[axis]) - static_cast<double>(box.lo[axis])) *
           static_cast<double>(grid_scale[axis]);
  };
  return size(0) * size(1) + size(1) * size(2) + size(2) * size(0);
}

}  // namespace vamp
