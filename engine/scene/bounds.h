#pragma once
// An axis-aligned box in scene units. A new one is empty: extend it.
#include <limits>

#include "engine/core/vec.h"

namespace vamp {

struct Bounds {
  vec3 lo{std::numeric_limits<float>::infinity()};
  vec3 hi{-std::numeric_limits<float>::infinity()};

  bool operator==(const Bounds&) const = default;
  bool empty() const { return !(lo.x <= hi.x && lo.y <= hi.y && lo.z <= hi.z); }
  void extend(const vec3& p) {
    lo = glm::min(lo, p);
    hi = glm::max(hi, p);
  }
  void extend(const Bounds& other) {
    lo = glm::min(lo, other.lo);
    hi = glm::max(hi, other.hi);
  }
  vec3 center() const { return empty() ? vec3(0) : lo * 0.5f + hi * 0.5f; }
  vec3 size() const { return empty() ? vec3(0) : hi - lo; }
  // Half the diagonal: the radius of the sphere around the box.
  float radius() const;
};

}  // namespace vamp
