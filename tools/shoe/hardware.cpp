#include "tools/shoe/hardware.h"

#include <cmath>
#include <numbers>

#include "tools/shoe/sweep.h"

namespace vamp::shoe {
namespace {

constexpr double kFromEdge = 8.5;  // of an eyelet's middle from the facing's edge, mm

// A ring turned about `axis`: a profile of (radius, height) from the outer foot over the crown down into the hole.
Mesh turned_ring(const Vec3& middle, const Vec3& axis, const Vec3& start) {
  constexpr int kAround = 24;
  const std::vector<Vec2> profile = {{3.55, -0.25}, {3.6, 0.1},  {3.5, 0.4},   {3.25, 0.62}, {2.9, 0.7},  {2.55, 0.66},
                                     {2.25, 0.5},   {2.05, 0.2}, {1.98, -0.2}, {1.95, -0.7}, {1.95, -1.6}};
  const Vec3 side = glm::normalize(start - glm::dot(start, axis) * axis);
  const Vec3 other = glm::cross(axis, side);
  std::vector<Vec3> points;
  std::vector<Vec2> uvs;
  double along = 0.0;
  for (size_t j = 0; j < profile.size(); ++j) {
    if (j > 0) along += glm::distance(profile[j], profile[j - 1]);
    for (int i = 0; i <= kAround; ++i) {
      const double turn = 2.0 * std::numbers::pi * i / kAround;
      points.push_back(middle + profile[j].x * (std::cos(turn) * side + std::sin(turn) * other) + profile[j].y * axis);
      // The crown's circumference stands for all rows: a ring is too small to show a pattern.
      uvs.emplace_back(2.8 * turn, along);
    }
  }
  Mesh mesh = grid(points, uvs, kAround + 1);
  mesh.smooth();
  for (size_t row = 0; row < points.size(); row += kAround + 1) {
    mesh.normals[row] = mesh.normals[row + kAround] = glm::normalize(mesh.normals[row] + mesh.normals[row + kAround]);
  }
  return mesh;
}

}  // namespace

Vec3 eyelet_place(const Upper& upper, const Last& last, int side, int row) {
  const Curve& facing = upper.facing[static_cast<size_t>(side)];
  const Curve line = inset(last, facing, side == 0 ? -kFromEdge : kFromEdge);
  return line(glm::mix(0.13, 0.92, double(row) / (kEyelets - 1)));
}

Mesh make_eyelets(const Upper& upper, const Last& last) {
  Mesh all;
  for (int side = 0; side < kSides; ++side) {
    for (int row = 0; row < kEyelets; ++row) {
      const Vec3 on = eyelet_place(upper, last, side, row);
      const Vec3 n = last.normal(on);
      const double face = face_height(upper.quarter[static_cast<size_t>(side)], on);
      all.append(turned_ring(on + face * n, n, Vec3(1.0, 0.0, 0.0)));
    }
  }
  return all;
}

Mesh make_pull_tab(const Upper& upper, const Last& last) {
  // In the plane of the back seam: up the outside, over the collar in a loop, down the inside.
  const auto at = [&](double above, double out) { return last.lifted(last.heel(0.0, above), out); };
  const double outside = face_height(upper.counter, last.heel(0.0, 30.0)) + 0.9;
  const Vec3 top = at(66.0, 0.0);
  const Curve path =
      spline({at(38.0, outside + 0.3), at(48.0, outside + 0.5), at(56.0, 4.6), at(64.0, 4.4),
              top + Vec3(-5.2, 6.0, 0.0), top + Vec3(-4.0, 12.0, 0.0), top + Vec3(0.5, 14.6, 0.0),
              top + Vec3(4.2, 11.0, 0.0), top + Vec3(5.2, 4.0, 0.0), at(61.0, -6.6), at(52.0, -6.0), at(44.0, -3.5)});
  Sweep strap;
  strap.path = path.evenly(90);
  for (size_t i = 0; i < strap.path.size(); ++i) {
    const Vec3 tangent = path.tangent(double(i) / double(strap.path.size() - 1));
    strap.up.push_back(glm::cross(tangent, Vec3(0.0, 0.0, 1.0)));
  }
  strap.section = flat_oval(13.0, 1.7, 8);
  strap.round_start = strap.round_end = true;
  return build(strap);
}

}  // namespace vamp::shoe
