#include "engine/scene/placement.h"

#include <cmath>

namespace vamp {
namespace {

// About the axis, counter-clockwise when it points to the viewer.
glm::dmat3 about(int axis, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  glm::dmat3 turned(1);
  turned[u][u] = c;
  turned[u][v] = s;
  turned[v][u] = -s;
  turned[v][v] = c;
  return turned;
}

}  // namespace

RigidMotion::RigidMotion(const Placement& place, const vec3& pivot)
    : turns_(place.turn != vec3(0)), pivot_(pivot), offset_(place.offset) {
  for (int axis = 0; axis < 3; ++axis) rotation_ = about(axis, static_cast<double>(place.turn[axis])) * rotation_;
}

vec3 RigidMotion::point(const vec3& p) const {
  const dvec3 from(p);
  return vec3(turns_ ? rotation_ * (from - pivot_) + (pivot_ + offset_) : from + offset_);
}

vec3 RigidMotion::direction(const vec3& d) const { return turns_ ? vec3(rotation_ * dvec3(d)) : d; }

Bounds RigidMotion::around(const Bounds& box) const {
  Bounds moved;
  if (box.empty()) return moved;
  for (int corner = 0; corner < 8; ++corner)
    moved.extend(
        point({corner & 1 ? box.hi.x : box.lo.x, corner & 2 ? box.hi.y : box.lo.y, corner & 4 ? box.hi.z : box.lo.z}));
  return moved;
}

}  // namespace vamp
