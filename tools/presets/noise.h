#pragma once
// Random numbers and noises on the torus: everything repeats without a seam, and is the same on every machine.
#include <cstdint>
#include <vector>

#include "engine/core/vec.h"

namespace vamp::presets {

using glm::dvec2;

// 0 to 1, from a hash of three integers.
double hash01(int64_t x, int64_t y, uint32_t seed);

// Gradient noise, about -1 to 1, of period `cells_x` by `cells_y` lattice cells; u, v in [0, 1) cover the period once.
double noise(double u, double v, int cells_x, int cells_y, uint32_t seed);

// `octaves` noises of doubling frequency and halving amplitude.
double fractal(double u, double v, int cells_x, int cells_y, int octaves, uint32_t seed);

// Where a point lies in a Voronoi pattern of jittered cells on the torus. Distances in cells.
struct CellPoint {
  double edge = 0;    // distance to the nearest border
  double corner = 0;  // excess of the third nearest site: small near junctions
  dvec2 from_site{0, 0};
  int64_t id = 0;
};
// `stretch` > 1 draws cells out along the direction `angle` (radians).
CellPoint cells(double u, double v, int count_x, int count_y, double jitter, double stretch, double angle,
                uint32_t seed);

inline double smoothstep(double low, double high, double x) {
  const double t = x <= low ? 0 : x >= high ? 1 : (x - low) / (high - low);
  return t * t * (3 - 2 * t);
}

}  // namespace vamp::presets
