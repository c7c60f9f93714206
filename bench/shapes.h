#pragma once
// A scene of known content and of any size, for measurements of rays against triangles.
#include "engine/project/project.h"

namespace vamp {

// Five bumpy spheres on a square floor of 5 x 5 units, in stripes of kShapesParts parts, seen from above, under a
// rectangle light and a constant ambient within a radius of 1, in one made-up material of 32 clusters, six functions a
// texel, four models and a residual with four terms (bench/material.h). `triangles`: about so many, from 500 up.
inline constexpr int kShapesParts = 8;
Project shapes_project(int triangles);

}  // namespace vamp
