#pragma once
// Mesostructures with known answers.
#include <vector>

#include "engine/acquire/height_field.h"

namespace vamp::acquire::test {

// A plane of Lambert facets of one albedo.
Mesostructure plane(int cells, float albedo);

// Roofs along y: height rises from 0 at x = 0 to `height` at x = 1/2 and falls again, in periods.
Mesostructure roof(int cells, double height, float albedo);

// A floor with a thin ridge of `height` periods along y, at x = 1/2, `width` wide.
Mesostructure ridge(int cells, double height, double width, float floor, float crest);

// Bumps that shadow and light one another, in three colours, under a Cook-Torrance coat or none.
Mesostructure bumps(int cells, float albedo, bool coated);

// Directions at these angles, in degrees.
vec3 towards(double theta, double phi);

}  // namespace vamp::acquire::test
