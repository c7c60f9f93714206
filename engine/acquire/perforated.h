#pragma once
// Leather with round holes in staggered rows, and a lining under them.
#include "engine/acquire/leather.h"

namespace vamp::acquire {

struct Perforated : Leather {
  Perforated();
  float holes = 4;        // across the period
  float hole_rows = 4;    // rounded to an even number
  float diameter = 1.3f;  // mm
  float sheet = 1.2f;     // mm, thickness of the leather
  vec3 lining{0.05f, 0.05f, 0.055f};
  vec3 edge_colour{0.42f, 0.31f, 0.21f};  // of the cut

  std::vector<Setting> settings() override;
  Mesostructure build(int cells) const override;
};

}  // namespace vamp::acquire
