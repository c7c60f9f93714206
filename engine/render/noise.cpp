#include "engine/render/noise.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

namespace vamp {
namespace {

// Rec.709.
float luminance(const float* rgba) { return 0.2126f * rgba[0] + 0.7152f * rgba[1] + 0.0722f * rgba[2]; }

// The median of each pixel's 3 x 3 surroundings; beyond the border the picture goes on as at the border.
std::vector<float> medians_of_3x3(const std::vector<float>& values, int width) {
  const auto w = static_cast<size_t>(width);
  const size_t height = values.size() / w;
  // With a column more at both ends, so that the compiler can work on many pixels of a row at once.
  std::array<std::vector<float>, 3> rows;
  for (auto& row : rows) row.resize(w + 2);
  const auto load = [&](std::vector<float>& row, size_t y) {
    std::copy_n(&values[y * w], w, row.begin() + 1);
    row.front() = row[1];
    row.back() = row[w];
  };
  std::vector<float> medians(values.size());
  const auto order = [](float& a, float& b) {
    const float low = std::min(a, b), high = std::max(a, b);
    a = low;
    b = high;
  };
  const auto sort = [order](float& a, float& b, float& c) {
    order(a, b);
    order(b, c);
    order(a, b);
  };
  for (size_t y = 0; y < height; ++y) {
    load(rows[0], y > 0 ? y - 1 : 0);
    load(rows[1], y);
    load(rows[2], std::min(y + 1, height - 1));
    const float *top = rows[0].data(), *middle = rows[1].data(), *bottom = rows[2].data();
    float* out = &medians[y * w];
    for (size_t x = 0; x < w; ++x) {
      float a = top[x], b = top[x + 1], c = top[x + 2];
      float d = middle[x], e = middle[x + 1], f = middle[x + 2];
      float g = bottom[x], h = bottom[x + 1], i = bottom[x + 2];
      // The median of three: the highest of the rows' lowest, the middle of their middle ones, the lowest of their
      // highest.
      sort(a, b, c);
      sort(d, e, f);
      sort(g, h, i);
      float low = std::max(std::max(a, d), g), high = std::min(std::min(c, f), i);
      sort(b, e, h);
      sort(low, e, high);
      out[x] = e;
    }
  }
  return medians;
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
  std::vector<float> now(linear.size() / 4);
  for (size_t i = 0; i < now.size(); ++i) now[i] = luminance(&linear[4 * i]);
  luminance_.resize(now.size());
  // A pixel's own luminance, which its error is to be related to, makes little of the very errors that count most,
  // those of pixels that are far too bright; the median of its surroundings makes too much of what is brighter than
  // they are. Each misses by up to a third, in opposite ways, on the scenes of `vamp bench noise`: the mean of both is
  // taken.
  const std::vector<float> typical = medians_of_3x3(now, width_);
  for (size_t t = 0; t < tiles_.size(); ++t) {
    Tile& tile = tiles_[t];
    const uint32_t samples = samples_of_tiles[t];
    if (!due(tile, samples)) continue;
    double sum = 0;
    for (int y = tile.area.y; y < tile.area.y + tile.area.height; ++y)
      for (int x = tile.area.x; x < tile.area.x + tile.area.width; ++x) {
        const size_t i = static_cast<size_t>(y) * static_cast<size_t>(width_) + static_cast<size_t>(x);
        const double d = double{now[i]} - double{luminance_[i]}, own{now[i]}, near{typical[i]};
        sum += d * d * 0.5 * (1 / (own * own + 0.01) + 1 / (near * near + 0.01));
        luminance_[i] = now[i];
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
