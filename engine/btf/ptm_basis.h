#pragma once
// The six functions of the light's direction in the order of PTM files.
#include <array>

#include "engine/core/vec.h"

namespace vamp {

inline std::array<double, 6> ptm_basis(const dvec3& light) {
  return {light.x * light.x, light.y * light.y, light.x * light.y, light.x, light.y, 1};
}

}  // namespace vamp
