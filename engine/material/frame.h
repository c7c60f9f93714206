#pragma once
// The frame of a function in double: as shaders/lib/spmm.glsl has it.
#include <algorithm>
#include <cmath>

#include "engine/core/vec.h"

namespace vamp {

// Into the frame about n whose tangent is the shortest-arc rotation of x, turned by psi (Duff et al. 2017).
struct BasisFrame {
  dvec3 t, b, n;
  BasisFrame(double x, double y, double cos_psi, double sin_psi) {
    const double z = std::sqrt(std::max(1 - x * x - y * y, 0.0));
    const double a = -1 / (1 + z), c = x * y * a;
    const dvec3 t0(1 + x * x * a, c, -x), b0(c, 1 + y * y * a, -y);
    t = t0 * cos_psi + b0 * sin_psi;
    b = b0 * cos_psi - t0 * sin_psi;
    n = dvec3(x, y, z);
  }
  BasisFrame(const dvec3& normal, double psi) : BasisFrame(normal.x, normal.y, std::cos(psi), std::sin(psi)) {}
  dvec3 local(const dvec3& w) const {
    const auto along = [&](const dvec3& axis) { return axis.x * w.x + axis.y * w.y + axis.z * w.z; };
    return {along(t), along(b), along(n)};
  }
};

}  // namespace vamp
