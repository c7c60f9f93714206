#pragma once
// Mesostructures without undercuts: a height over every point of the period.
#include <cstdint>
#include <functional>
#include <vector>

#include "engine/acquire/facet.h"

namespace vamp::acquire {

// What lies at a point.
struct Skin {
  double height = 0;  // mm
  vec3 colour{0.5f};
  float grain = 0;  // direction of the coat's x axis, radians from the x axis
  uint8_t matter = 0;
};

// 2 * cells^2 facets through the heights at the corners of the cells; colour, grain and matter are those of the lower
// left corner. `skin` is asked on several threads, with u and v in [0, 1), and must repeat.
std::vector<Facet> height_field(int cells, double mm, const std::function<Skin(double u, double v)>& skin);

}  // namespace vamp::acquire
