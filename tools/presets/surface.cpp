#include "tools/presets/surface.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/brdf/registry.h"

namespace vamp::presets {
namespace {

int wrap(int value, int period) { return ((value % period) + period) % period; }

}  // namespace

Basis tilted_basis(std::string name, Model model, std::initializer_list<float> params, double tilt, double azimuth,
                   double psi) {
  const double t = tilt * std::numbers::pi / 180, a = azimuth * std::numbers::pi / 180;
  Lobe lobe = default_lobe(model);
  std::copy(params.begin(), params.end(), lobe.params.begin());
  return {std::move(name), lobe,
          vec3(static_cast<float>(std::sin(t) * std::cos(a)), static_cast<float>(std::sin(t) * std::sin(a)),
               static_cast<float>(std::cos(t))),
          static_cast<float>(psi * std::numbers::pi / 180)};
}

std::vector<vec3> texel_normals(const Surface& surface) {
  std::vector<vec3> normals(size_t{kSide} * kSide);
  const float spacing = static_cast<float>(surface.mm) / kFineSide;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const auto at = [&](int i, int j) {
        return surface
            .height[static_cast<size_t>(wrap(y * kFine + j, kFineSide) * kFineSide + wrap(x * kFine + i, kFineSide))];
      };
      float sx = 0, sy = 0;
      for (int j = 0; j < kFine; ++j) sx += at(kFine, j) - at(-1, j);
      for (int i = 0; i < kFine; ++i) sy += at(i, kFine) - at(i, -1);
      const float run = spacing * (kFine + 1) * kFine;
      const vec3 n(-sx / run, -sy / run, 1);
      normals[static_cast<size_t>(y * kSide + x)] = n / std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z);
    }
  return normals;
}

}  // namespace vamp::presets
