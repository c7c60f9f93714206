#include "engine/acquire/height_field.h"

#include <cmath>

#include "engine/acquire/parallel.h"

namespace vamp::acquire {

std::vector<Facet> height_field(int cells, double mm, const std::function<Skin(double u, double v)>& skin) {
  const auto side = static_cast<size_t>(cells);
  std::vector<Skin> skins(side * side);
  parallel(0, cells, [&](int y) {
    for (int x = 0; x < cells; ++x)
      skins[static_cast<size_t>(y) * side + static_cast<size_t>(x)] =
          skin(static_cast<double>(x) / cells, static_cast<double>(y) / cells);
    return true;
  });
  const auto corner = [&](size_t x, size_t y) {
    return vec3(static_cast<float>(x) / static_cast<float>(cells), static_cast<float>(y) / static_cast<float>(cells),
                static_cast<float>(skins[y % side * side + x % side].height / mm));
  };
  std::vector<Facet> facets;
  facets.reserve(2 * side * side);
  for (size_t y = 0; y < side; ++y)
    for (size_t x = 0; x < side; ++x) {
      const Skin& at = skins[y * side + x];
      const vec3 fibre(std::cos(at.grain), std::sin(at.grain), 0);
      const vec3 a = corner(x, y), b = corner(x + 1, y), c = corner(x + 1, y + 1), d = corner(x, y + 1);
      // Diagonals take turns, so that no direction is favoured.
      const bool rising = (x + y) % 2 == 0;
      facets.push_back({rising ? std::array{a, b, c} : std::array{a, b, d}, at.colour, fibre, at.matter});
      facets.push_back({rising ? std::array{a, c, d} : std::array{b, c, d}, at.colour, fibre, at.matter});
    }
  return facets;
}

}  // namespace vamp::acquire
