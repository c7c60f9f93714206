#pragma once
// Measured direction sets, and where a direction falls between them: the arithmetic that the kernels share.
#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "engine/core/vec.h"
#include "engine/material/tables.h"

namespace vamp {

// The 81 directions of the Bonn UBO2003 gonioreflectometer (Sattler et al. 2003): rings at 0, 15 .. 75 degrees with
// 1, 6, 12, 18, 20 and 24 azimuths from 0.
std::vector<vec3> ubo2003_directions();

// Cosine of the outermost measured ring, at least 1e-3. Past it the residual of a light is multiplied by
// min(1, cos / this), so that it vanishes at the horizon (algorithms.md 2.8).
float last_ring_cosine(const std::vector<vec3>& directions);

// Three measured directions and their weights; weights are >= 0 and sum to 1.
template <class T>
struct DirectionWeights {
  std::array<int, 3> slot;
  std::array<T, 3> weight;
};

// A direction's place on the parabolic disk, p = (x, y) / (1 + z); z >= 0.
template <class Vec>
DirectionWeights<typename Vec::value_type> find_direction(const DirectionTables& tables, const Vec& w) {
  using T = typename Vec::value_type;
  const T px = w.x / (T(1) + w.z), py = w.y / (T(1) + w.z);
  const auto cell = [](T p) {
    return std::clamp(static_cast<int>((p * T(0.5) + T(0.5)) * T(kDirectionMapSide)), 0, kDirectionMapSide - 1);
  };
  const auto& triangle =
      tables.triangles[tables.map[static_cast<size_t>(cell(py)) * kDirectionMapSide + static_cast<size_t>(cell(px))]];
  const auto row = [&](const float* r) { return T(r[0]) * px + T(r[1]) * py + T(r[2]); };
  T a = row(triangle.row1), b = row(triangle.row2);
  T c = T(1) - a - b;
  a = std::max(a, T(0)), b = std::max(b, T(0)), c = std::max(c, T(0));
  const T scale = T(1) / (a + b + c);
  const auto slot = [&](int vertex) { return static_cast<int>((triangle.slots >> (10 * vertex)) & 1023u); };
  return {{slot(0), slot(1), slot(2)}, {a * scale, b * scale, c * scale}};
}

}  // namespace vamp
