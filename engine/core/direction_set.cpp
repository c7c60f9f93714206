#include "engine/core/direction_set.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace vamp {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

struct Ring {
  double theta, first_phi;  // degrees
  int count;
};

template <size_t N>
DirectionSet rings(std::string name, const Ring (&rows)[N]) {
  DirectionSet set{std::move(name), {}};
  for (const Ring& ring : rows)
    for (int i = 0; i < ring.count; ++i)
      set.directions.push_back(
          direction_of({ring.theta * kDegree, (ring.first_phi + i * 360.0 / ring.count) * kDegree}));
  return set;
}

bool same(const DirectionSet& a, const std::vector<dvec3>& b) {
  return std::equal(a.directions.begin(), a.directions.end(), b.begin(), b.end(),
                    [](const dvec3& u, const dvec3& v) { return std::hypot(u.x - v.x, u.y - v.y, u.z - v.z) < 1e-3; });
}

}  // namespace

dvec3 direction_of(SphericalAngles angles) {
  const double s = std::sin(angles.theta);
  return {s * std::cos(angles.phi), s * std::sin(angles.phi), std::cos(angles.theta)};
}

SphericalAngles angles_of(const dvec3& direction) {
  const double across = std::hypot(direction.x, direction.y);
  if (across < 1e-12) return {direction.z < 0 ? std::numbers::pi : 0, 0};
  const double phi = std::atan2(direction.y, direction.x);
  const double full = phi < 0 ? phi + 2 * std::numbers::pi : phi;
  // A phi just below 0 rounds to the full circle, which is 0.
  return {std::atan2(across, direction.z), full < 2 * std::numbers::pi ? full : 0};
}

DirectionSet ubo81() {
  return rings("ubo81", {{0, 0, 1}, {15, 0, 6}, {30, 0, 12}, {45, 0, 18}, {60, 0, 20}, {75, 0, 24}});
}

DirectionSet dome151() {
  return rings("dome151", {{0, 0, 1},
                           {11, 15, 6},
                           {23.5, 0, 12},
                           {30, 15, 12},
                           {37.5, 0, 12},
                           {45, 0, 18},
                           {52.5, 7.5, 18},
                           {60, 0, 24},
                           {67.5, 7.5, 24},
                           {75, 0, 24}});
}

DirectionSet named_direction_set(std::vector<dvec3> directions) {
  for (DirectionSet known : {ubo81(), dome151()})
    if (same(known, directions)) return {std::move(known.name), std::move(directions)};
  return {"own", std::move(directions)};
}

}  // namespace vamp
