#include "engine/material/directions.h"

#include "engine/core/direction_set.h"

namespace vamp {

std::vector<vec3> ubo2003_directions() {
  std::vector<vec3> directions;
  for (const dvec3& direction : ubo81().directions) directions.emplace_back(direction);
  return directions;
}

float last_ring_cosine(const std::vector<vec3>& directions) {
  float lowest = 1;
  for (const vec3& w : directions) lowest = std::min(lowest, w.z);
  return std::max(lowest, 1e-3f);
}

}  // namespace vamp
