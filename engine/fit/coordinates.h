#pragma once
// A measurement's leading singular vectors, streamed: what texels are clustered by, and the truncated SVD (full matrix
// factorisation) that other representations are compared with.
#include <vector>

#include "engine/fit/measurement.h"
#include "engine/fit/parallel.h"
#include "engine/fit/rows.h"

namespace vamp::fit {

// Weighted texel t is close to sum over k of coordinates[t][k] * directions[k]; directions are orthonormal rows of
// Measurement::values() floats. Distances between coordinates are those between (truncated) texels.
struct Coordinates {
  Rows directions;    // rank x values
  Rows coordinates;   // texels x rank, by falling energy
  double square = 0;  // of all texels
};

struct CoordinateOptions {
  size_t rank = 64, oversampling = 10;
  int power_iterations = 2;
  size_t sample = 4096;  // texels that the directions are made from, evenly spread; all are then projected
  uint64_t seed = 1;
};

// Randomised range finder (Halko, Martinsson and Tropp 2011, algorithm 4.4). The rank is at most the number of texels;
// directions without energy are left out.
Coordinates find_coordinates(const Measurement& measurement, const CoordinateOptions& options, const Worker& worker);

}  // namespace vamp::fit
