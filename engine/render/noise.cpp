#include "engine/render/noise.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace vamp {
namespace {

// Rec.709.
float luminance(const float* rgba) { return 0.2126f * rgba[0] + 0.7152f * rgba[1] + 0.0722f * rgba[2]; }

// The median of 3 x 3 pixels. A pixel's own luminance, which its error is to be related to, makes little of the very
// errors that count most, those of pixels that are far too bright; the median makes too much of what is brighter than
// its surroundings. Each misses by up to a third, in opposite ways, on the scenes of `vamp bench noise`: the mean of
// both is taken.
float typical_luminance(const std::vector<float>& linear, int width, int x, int y) {
  const int height = static_cast<int>(linear.size() / 4) / width;
  std::array<float, 9> near{};
  auto end = near.begin();
  for (int v = std::max(y - 1, 0); v <= std::min(y + 1, height - 1); ++v)
    for (int u = std::max(x - 1, 0); u <= std::min(x + 1, width - 1); ++u)
      *end++ = luminance(&linear[4 * (static_cast<size_t>(v) * static_cast<size_t>(width) + static_cast<size_t>(u))]);
  const auto middle = near.begin() + (end - near.begin()) / 2;
  std::nth_element(near.begin(), middle, end);
  return *middle;
}

}  // namespace

void NoiseEstimate::restart(std::span<const Region> tiles, int width) {
  tiles_.clear();
  for (const Region& area : tiles) tiles_.push_back({.area = area});
  width_ = width;
  luminance_.clear();
}

void NoiseEstimate::forget_picture() {
  for (Tile& tile : tiles_) tile.shown = 0;
}

bool NoiseEstimate::due(const Tile& tile, uint32_t samples) {
  return samples >= 4 && std::has_single_bit(samples) && samples != tile.shown;
}

bool NoiseEstimate::due(std::span<const uint32_t> samples_of_tiles) const {
  for (size_t t = 0; t < tiles_.size(); ++t)
    if (due(tiles_[t], samples_of_tiles[t])) return true;
  return false;
}

void NoiseEstimate::add(std::span<const uint32_t> samples_of_tiles, const std::vector<float>& linear) {
  luminance_.resize(linear.size() / 4);
  for (size_t t = 0; t < tiles_.size(); ++t) {
    Tile& tile = tiles_[t];
    const uint32_t samples = samples_of_tiles[t];
    if (!due(tile, samples)) continue;
    double sum = 0;
    for (int y = tile.area.y; y < tile.area.y + tile.area.height; ++y)
      for (int x = tile.area.x; x < tile.area.x + tile.area.width; ++x) {
        const size_t i = static_cast<size_t>(y) * static_cast<size_t>(width_) + static_cast<size_t>(x);
        const float now = luminance(&linear[4 * i]);
        const double d = double{now} - double{luminance_[i]};
        const double own{now}, typical{typical_luminance(linear, width_, x, y)};
        sum += d * d * 0.5 * (1 / (own * own + 0.01) + 1 / (typical * typical + 0.01));
        luminance_[i] = now;
      }
    if (samples == 2 * tile.shown) {
      tile.d2_before = samples == 2 * tile.compared ? tile.d2 : 0;
      tile.d2 = sum / (static_cast<double>(tile.area.width) * tile.area.height);
      tile.compared = samples;
    }
    tile.shown = samples;
  }
}

double NoiseEstimate::squared_error(const Tile& tile, uint32_t samples) const {
  const double r = tile.d2 > 0 ? std::clamp(tile.d2_before / tile.d2, 2.0, 4.0) : 2.0;
  const double doublings = std::log2(static_cast<double>(samples) / tile.compared);
  return tile.d2 / (r - 1) * std::pow(r, -doublings);
}

float NoiseEstimate::of_tile(size_t tile, uint32_t samples) const {
  if (tile >= tiles_.size() || tiles_[tile].compared == 0 || samples == 0) return -1;
  return static_cast<float>(std::sqrt(squared_error(tiles_[tile], samples)));
}

float NoiseEstimate::of_picture(std::span<const uint32_t> samples_of_tiles) const {
  double sum = 0, pixels = 0;
  for (size_t t = 0; t < tiles_.size(); ++t) {
    const Tile& tile = tiles_[t];
    if (tile.compared == 0 || samples_of_tiles[t] == 0) return -1;
    const double area = static_cast<double>(tile.area.width) * tile.area.height;
    sum += area * squared_error(tile, samples_of_tiles[t]);
    pixels += area;
  }
  return pixels > 0 ? static_cast<float>(std::sqrt(sum / pixels)) : -1;
}

}  // namespace vamp
