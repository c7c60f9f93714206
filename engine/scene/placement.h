#pragma once
// Where a part stands that was moved from where its model has it.
#include <glm/mat3x3.hpp>

#include "engine/core/vec.h"
#include "engine/scene/bounds.h"

namespace vamp {

struct Placement {
  vec3 offset{0, 0, 0};  // scene units
  vec3 turn{0, 0, 0};    // radians about X, then Y, then Z, through the middle of the part's bounds

  bool operator==(const Placement&) const = default;
};

// What a placement does to points and directions, in double and rounded once. At rest they stay as they are, bit for
// bit.
class RigidMotion {
 public:
  RigidMotion() = default;
  // `pivot`: what it turns about.
  RigidMotion(const Placement& place, const vec3& pivot);

  bool turns() const { return turns_; }
  vec3 point(const vec3& p) const;
  // Unit vectors stay unit vectors, to rounding.
  vec3 direction(const vec3& d) const;
  // A box around what stands in the box; no larger than it must be where nothing turns.
  Bounds around(const Bounds& box) const;

 private:
  bool turns_ = false;
  glm::dmat3 rotation_{1};
  dvec3 pivot_{0}, offset_{0};
};

}  // namespace vamp
