#pragma once
// A small material with everything in it: three clusters, five functions of five models, tilted frames, a residual.
#include <random>

#include "engine/material/spmm.h"

namespace vamp::test {

Spmm small_spmm(uint32_t seed = 1);

// Directions of a fixed random sequence over the upper hemisphere, uniform in solid angle.
dvec3 random_direction(std::mt19937& random);

// n with the given tilt and azimuth in degrees.
vec3 tilted(double tilt, double azimuth);

}  // namespace vamp::test
