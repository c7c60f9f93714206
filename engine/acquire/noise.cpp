#include "engine/acquire/noise.h"

#include <cmath>
#include <numbers>

#include "engine/acquire/random.h"

namespace vamp::acquire::noise {
namespace {

int64_t wrap(int64_t value, int64_t period) { return ((value % period) + period) % period; }

}  // namespace

double hash01(int64_t x, int64_t y, uint32_t seed) {
  return static_cast<double>(hash_bits(static_cast<uint64_t>(x), static_cast<uint64_t>(y), seed) >> 11) * 0x1p-53;
}

double gradient(double u, double v, int cells_x, int cells_y, uint32_t seed) {
  const double x = u * cells_x, y = v * cells_y;
  const auto ix = static_cast<int64_t>(std::floor(x)), iy = static_cast<int64_t>(std::floor(y));
  const double fx = x - std::floor(x), fy = y - std::floor(y);
  const auto corner = [&](int64_t dx, int64_t dy) {
    const double angle = 2 * std::numbers::pi * hash01(wrap(ix + dx, cells_x), wrap(iy + dy, cells_y), seed);
    return std::cos(angle) * (fx - static_cast<double>(dx)) + std::sin(angle) * (fy - static_cast<double>(dy));
  };
  const auto fade = [](double t) { return t * t * t * (t * (t * 6 - 15) + 10); };
  const double low = std::lerp(corner(0, 0), corner(1, 0), fade(fx));
  const double high = std::lerp(corner(0, 1), corner(1, 1), fade(fx));
  return 1.5 * std::lerp(low, high, fade(fy));
}

double fractal(double u, double v, int cells_x, int cells_y, int octaves, uint32_t seed) {
  double sum = 0, amplitude = 1;
  for (int i = 0; i < octaves; ++i, amplitude *= 0.5)
    sum += amplitude * gradient(u, v, cells_x << i, cells_y << i, seed + static_cast<uint32_t>(i) * 101);
  return sum;
}

CellPoint cells(double u, double v, int count_x, int count_y, double jitter, uint32_t seed, double stagger) {
  constexpr int kReach = 2;  // a jittered site is never further than that when it matters
  const double y = v * count_y;
  const auto iy = static_cast<int64_t>(std::floor(y));
  struct Site {
    glm::dvec2 offset;  // from the point
    double distance2;
    int64_t id;
  };
  Site sites[(2 * kReach + 1) * (2 * kReach + 1)];
  int count = 0, best = 0;
  for (int64_t dy = -kReach; dy <= kReach; ++dy) {
    const int64_t row = wrap(iy + dy, count_y);
    const double shift = row % 2 != 0 ? stagger : 0;
    const double x = u * count_x - shift;
    const auto ix = static_cast<int64_t>(std::floor(x));
    for (int64_t dx = -kReach; dx <= kReach; ++dx) {
      const int64_t column = wrap(ix + dx, count_x);
      const glm::dvec2 offset(static_cast<double>(ix + dx) + 0.5 + jitter * (hash01(column, row, seed) - 0.5) - x,
                              static_cast<double>(iy + dy) + 0.5 + jitter * (hash01(column, row, seed + 7) - 0.5) - y);
      sites[count] = {offset, offset.x * offset.x + offset.y * offset.y, column + row * count_x};
      if (sites[count].distance2 < sites[best].distance2) best = count;
      ++count;
    }
  }
  double edge = 1e9;
  for (int i = 0; i < count; ++i) {
    if (i == best) continue;
    const glm::dvec2 between = sites[i].offset - sites[best].offset;
    const double length = std::hypot(between.x, between.y);
    edge = std::min(edge, (sites[i].distance2 - sites[best].distance2) / (2 * length));
  }
  return {edge, std::sqrt(sites[best].distance2), -sites[best].offset, sites[best].id};
}

}  // namespace vamp::acquire::noise
