#pragma once
// How noisy a progressive picture still is, from the picture alone.
#include <cstdint>
#include <span>
#include <vector>

#include "engine/render/region.h"

namespace vamp {

// For each tile, compares the mean at n samples with the mean at n / 2. With a and b the errors of the two halves, the
// difference is d = (b - a) / 2 and the error of the whole e = (a + b) / 2, so that d^2 + e^2 is the squared error at
// n / 2 in the mean, however the halves depend on each other: those of scrambled Sobol points complement each other,
// and d alone would over-estimate. If the squared error falls by a factor r with each doubling, so does d^2, and e^2 =
// d^2 / (r - 1); r is taken from the last two comparisons, between 2 (independent samples) and 4. Errors are relative
// as in relMSE: sqrt(mean(error^2 / (luminance^2 + 0.01))).
class NoiseEstimate {
 public:
  // Nothing is known; tiles of a picture of this width.
  void restart(std::span<const Region> tiles, int width);
  // The pictures to come are of something else, but about as noisy.
  void forget_picture();

  // Whether some tile stands at a number of samples at which it is to be compared: powers of two from 4.
  bool due(std::span<const uint32_t> samples_of_tiles) const;
  // `linear`: RGBA of the whole picture; tiles of which nothing is due are left alone.
  void add(std::span<const uint32_t> samples_of_tiles, const std::vector<float>& linear);

  // Of a tile at so many samples, falling from the last comparison at its rate; -1: not known yet.
  float of_tile(size_t tile, uint32_t samples) const;
  // Of the picture; -1: some tile is not known yet.
  float of_picture(std::span<const uint32_t> samples_of_tiles) const;

 private:
  struct Tile {
    Region area;
    uint32_t shown = 0;            // samples that luminance_ holds of it
    uint32_t compared = 0;         // of the last comparison; 0: none
    double d2 = 0, d2_before = 0;  // means over its pixels: of the last comparison, and at half as many samples or 0
  };
  static bool due(const Tile& tile, uint32_t samples);
  double squared_error(const Tile& tile, uint32_t samples) const;

  std::vector<Tile> tiles_;
  int width_ = 0;
  std::vector<float> luminance_;
};

}  // namespace vamp
