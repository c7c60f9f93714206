#pragma once
// Sets of directions under which materials are measured: unit vectors in the material's frame, z the normal, pointing
// away from the surface.
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/vec.h"

namespace vamp {

struct DirectionSet {
  std::string name;               // "ubo81", "dome151", "own"
  std::vector<dvec3> directions;  // unit, z >= 0, in the order of the measurement

  size_t size() const { return directions.size(); }
  const dvec3& operator[](size_t i) const { return directions[i]; }
};

// theta from the normal, phi from the x axis, in radians.
struct SphericalAngles {
  double theta = 0;  // 0 to pi
  double phi = 0;    // 0 to below 2 pi; 0 on the normal
};
dvec3 direction_of(SphericalAngles angles);
SphericalAngles angles_of(const dvec3& direction);

// The 81 directions of the Bonn UBO2003 gonioreflectometer, also those of UTIA (Sattler, Sarlette, Klein 2003): rings
// at 0, 15 .. 75 degrees with 1, 6, 12, 18, 20 and 24 azimuths from 0.
DirectionSet ubo81();

// The 151 directions of the Bonn Dome-1 (UBO2014; Schwartz et al. 2014): rings at 0, 11, 23.5, 30, 37.5 .. 75 degrees
// with 1, 6, 12, 12, 12, 18, 18, 24, 24 and 24 azimuths.
DirectionSet dome151();

// These directions under the name of the standard set that they equal, in its order, to within 1e-3 radians; else under
// "own".
DirectionSet named_direction_set(std::vector<dvec3> directions);

}  // namespace vamp
