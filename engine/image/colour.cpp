#include "engine/image/colour.h"

#include <cmath>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

namespace vamp {
namespace {

using glm::dmat3;
using glm::dvec3;

dvec3 xyz_of(double x, double y) { return {x / y, 1.0, (1.0 - x - y) / y}; }

// SMPTE RP 177: scales the primaries so that their sum is the white.
dmat3 xyz_from_rgb(const std::array<float, 8>& c) {
  const dmat3 primaries(xyz_of(c[0], c[1]), xyz_of(c[2], c[3]), xyz_of(c[4], c[5]));
  const dvec3 scale = glm::inverse(primaries) * xyz_of(c[6], c[7]);
  return {primaries[0] * scale.x, primaries[1] * scale.y, primaries[2] * scale.z};
}

}  // namespace

std::vector<float> decoding_table(size_t count, ColourSpace space) {
  std::vector<float> table(count);
  for (size_t code = 0; code < count; ++code) {
    const double v = static_cast<double>(code) / static_cast<double>(count - 1);
    const double linear = v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    table[code] = static_cast<float>(space == ColourSpace::srgb ? linear : v);
  }
  return table;
}

bool matrix_to_rec709(const std::array<float, 8>& chromaticities, std::array<double, 9>& matrix) {
  const dmat3 from = xyz_from_rgb(chromaticities);
  const dmat3 to = xyz_from_rgb(kRec709);
  // glm's constructors take columns.
  const dmat3 bradford =
      glm::transpose(dmat3(0.8951, 0.2664, -0.1614, -0.7502, 1.7135, 0.0367, 0.0389, -0.0685, 1.0296));
  const dvec3 old_cone = bradford * xyz_of(chromaticities[6], chromaticities[7]);
  const dvec3 new_cone = bradford * xyz_of(kRec709[6], kRec709[7]);
  const dvec3 gain = new_cone / old_cone;
  const dmat3 adapt = glm::inverse(bradford) * dmat3(gain.x, 0, 0, 0, gain.y, 0, 0, 0, gain.z) * bradford;
  const dmat3 all = glm::inverse(to) * adapt * from;
  bool sound = true;
  for (int row = 0; row < 3; ++row)
    for (int column = 0; column < 3; ++column) {
      matrix[static_cast<size_t>(row * 3 + column)] = all[column][row];
      sound = sound && std::isfinite(all[column][row]) && std::abs(all[column][row]) < 100.0;
    }
  return sound;
}

}  // namespace vamp
