#pragma once
// A BTF of a few texels whose every value is its own.
#include <cstddef>

#include "engine/btf/btf.h"

namespace vamp::test {

// 5 x 3 texels, the 81 views, 4 lights.
inline BtfInfo small_info() {
  BtfInfo info;
  info.width = 5;
  info.height = 3;
  info.views = ubo81();
  info.lights = named_direction_set(
      {direction_of({0, 0}), direction_of({0.3, 0.1}), direction_of({0.7, 3}), direction_of({1.2, 6})});
  info.mm_per_texel = 0.25f;
  return info;
}

// Multiples of 1 / 1024 below 2: exact as halves.
inline float value_at(size_t texel, size_t view, size_t light, size_t channel) {
  const size_t index = ((texel * 81 + view) * 4 + light) * 3 + channel;
  return static_cast<float>(index * 7 % 2048) / 1024;
}

inline void fill(Btf& btf) {
  for (size_t t = 0; t < btf.texel_count(); ++t)
    for (size_t v = 0; v < btf.view_count(); ++v)
      for (size_t l = 0; l < btf.light_count(); ++l)
        for (size_t c = 0; c < 3; ++c)
          btf.writable_texel(t)[(v * btf.light_count() + l) * 3 + c] = half_from_float(value_at(t, v, l, c));
}

}  // namespace vamp::test
