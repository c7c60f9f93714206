#include "engine/material/directions.h"

#include <numbers>

namespace vamp {

std::vector<vec3> ubo2003_directions() {
  constexpr int kCounts[] = {1, 6, 12, 18, 20, 24};
  std::vector<vec3> directions;
  for (int ring = 0; ring < 6; ++ring) {
    const double theta = ring * 15 * std::numbers::pi / 180;
    for (int i = 0; i < kCounts[ring]; ++i) {
      const double phi = 2 * std::numbers::pi * i / kCounts[ring];
      directions.emplace_back(static_cast<float>(std::sin(theta) * std::cos(phi)),
                              static_cast<float>(std::sin(theta) * std::sin(phi)), static_cast<float>(std::cos(theta)));
    }
  }
  return directions;
}

float last_ring_cosine(const std::vector<vec3>& directions) {
  float lowest = 1;
  for (const vec3& w : directions) lowest = std::min(lowest, w.z);
  return std::max(lowest, 1e-3f);
}

}  // namespace vamp
