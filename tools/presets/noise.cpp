#include "tools/presets/noise.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vamp::presets {
namespace {

int64_t wrap(int64_t value, int64_t period) { return ((value % period) + period) % period; }

}  // namespace

double hash01(int64_t x, int64_t y, uint32_t seed) {
  // SplitMix64 (Steele et al. 2014) over the mixed integers.
  uint64_t z = static_cast<uint64_t>(x) * 0x9e3779b97f4a7c15ull ^ static_cast<uint64_t>(y) * 0xc2b2ae3d27d4eb4full ^
               (uint64_t{seed} + 1) * 0x165667b19e3779f9ull;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9ull;
  z = (z ^ (z >> 27)) * 0x94d049bb133111ebull;
  return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

double noise(double u, double v, int cells_x, int cells_y, uint32_t seed) {
  const double x = u * cells_x, y = v * cells_y;
  const auto ix = static_cast<int64_t>(std::floor(x)), iy = static_cast<int64_t>(std::floor(y));
  const double fx = x - std::floor(x), fy = y - std::floor(y);
  const auto corner = [&](int64_t dx, int64_t dy) {
    const double angle = 2 * std::numbers::pi * hash01(wrap(ix + dx, cells_x), wrap(iy + dy, cells_y), seed);
    return std::cos(angle) * (fx - static_cast<double>(dx)) + std::sin(angle) * (fy - static_cast<double>(dy));
  };
  const auto fade = [](double t) { return t * t * t * (t * (t * 6 - 15) + 10); };
  const double sx = fade(fx), sy = fade(fy);
  const double low = corner(0, 0) + (corner(1, 0) - corner(0, 0)) * sx;
  const double high = corner(0, 1) + (corner(1, 1) - corner(0, 1)) * sx;
  return 1.5 * (low + (high - low) * sy);
}

double fractal(double u, double v, int cells_x, int cells_y, int octaves, uint32_t seed) {
  double sum = 0, amplitude = 1;
  for (int i = 0; i < octaves; ++i, amplitude *= 0.5)
    sum += amplitude * noise(u, v, cells_x << i, cells_y << i, seed + static_cast<uint32_t>(i) * 101);
  return sum;
}

CellPoint cells(double u, double v, int count_x, int count_y, double jitter, double stretch, double angle,
                uint32_t seed) {
  const double x = u * count_x, y = v * count_y, c = std::cos(angle), s = std::sin(angle);
  const auto ix = static_cast<int64_t>(std::floor(x)), iy = static_cast<int64_t>(std::floor(y));
  struct Site {
    double distance2;
    dvec2 offset;
    int64_t id;
  };
  Site best[3] = {{1e9, {}, 0}, {1e9, {}, 0}, {1e9, {}, 0}};
  double edge = 1e9;
  Site all[49];
  int count = 0;
  for (int64_t dy = -3; dy <= 3; ++dy)
    for (int64_t dx = -3; dx <= 3; ++dx) {
      const int64_t wx = wrap(ix + dx, count_x), wy = wrap(iy + dy, count_y);
      const double ox = static_cast<double>(ix + dx) + 0.5 + jitter * (hash01(wx, wy, seed) - 0.5) - x;
      const double oy = static_cast<double>(iy + dy) + 0.5 + jitter * (hash01(wx, wy, seed + 7) - 0.5) - y;
      const dvec2 o((c * ox + s * oy) / stretch, (c * oy - s * ox) * stretch);
      all[count] = {o.x * o.x + o.y * o.y, o, wx + wy * count_x};
      Site site = all[count++];
      for (Site& b : best)
        if (site.distance2 < b.distance2) std::swap(site, b);
    }
  for (int i = 0; i < count; ++i) {
    const dvec2 between = all[i].offset - best[0].offset, middle = (all[i].offset + best[0].offset) * 0.5;
    const double length = std::sqrt(between.x * between.x + between.y * between.y);
    if (length > 1e-9) edge = std::min(edge, (middle.x * between.x + middle.y * between.y) / length);
  }
  return {edge, std::sqrt(best[2].distance2) - std::sqrt(best[0].distance2), dvec2(0) - best[0].offset, best[0].id};
}

}  // namespace vamp::presets
