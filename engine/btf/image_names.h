#pragma once
// The angles in the names of a BTF's pictures, as Bonn (UBO2003, ATRIUM, SPECTRAL) and UTIA write them.
#include <optional>
#include <string>
#include <string_view>

#include "engine/core/direction_set.h"

namespace vamp {

// In degrees, as the name says them.
struct ImageAngles {
  double light_theta = 0, light_phi = 0, view_theta = 0, view_phi = 0;
};

// "00008 tl000 pl000 tv030 pv030.jpg", "tv30_pv0_tl7.5_pl15.exr": four numbers behind tl, pl, tv and pv in any order;
// nothing when one of them is missing.
std::optional<ImageAngles> image_angles(std::string_view name);

// "tl000_pl000_tv030_pv018", as UTIA writes it; fractions of a degree as Bonn's SPECTRAL set does.
std::string image_name(const dvec3& light, const dvec3& view);

}  // namespace vamp
