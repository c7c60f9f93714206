#pragma once
// Noises on the torus: (u, v) in periods, everything repeats without a seam and is the same on every machine.
#include <algorithm>
#include <cstdint>
#include <glm/vec2.hpp>

namespace vamp::acquire::noise {

// 0 to 1, from a hash of a lattice point.
double hash01(int64_t x, int64_t y, uint32_t seed);

// Gradient noise, about -1 to 1, of cells_x by cells_y lattice cells a period (Perlin 2002, "Improving noise").
double gradient(double u, double v, int cells_x, int cells_y, uint32_t seed);

// `octaves` of it, each of twice the frequency and half the amplitude of the one before.
double fractal(double u, double v, int cells_x, int cells_y, int octaves, uint32_t seed);

// Where a point lies among the cells of jittered sites (Worley 1996). Lengths in cells.
struct CellPoint {
  double edge = 0;    // to the nearest border
  double centre = 0;  // to the cell's site
  glm::dvec2 from_site{0, 0};
  int64_t id = 0;  // of the cell
};
// jitter 0: a square lattice; 1: anywhere in its square. Odd rows are shifted by `stagger` of a cell (count_y even).
CellPoint cells(double u, double v, int count_x, int count_y, double jitter, uint32_t seed, double stagger = 0);

inline double smooth_step(double low, double high, double x) {
  const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
  return t * t * (3 - 2 * t);
}

}  // namespace vamp::acquire::noise
