#include "engine/acquire/perforated.h"

#include <algorithm>
#include <cmath>

#include "engine/acquire/noise.h"

namespace vamp::acquire {

Perforated::Perforated() {
  name = "perforated";
  mm = 12;
  plates = 26;
  plate_height = 0.035f;
  wrinkles = 0.01f;
  pores = 0.1f;
  pore_depth = 0.03f;
  mottling = 0.05f;
  colour = vec3(0.62f, 0.60f, 0.56f);
  crease_colour = vec3(0.44f, 0.42f, 0.38f);
  roughness = 0.26f;
}

std::vector<Setting> Perforated::settings() {
  std::vector<Setting> all = Leather::settings();
  all.insert(all.end(), {
                            {"holes", &holes, 1, 60, "holes across the period"},
                            {"hole_rows", &hole_rows, 2, 60, "rows of them, rounded to an even number"},
                            {"diameter", &diameter, 0.1f, 20, "mm, of the holes"},
                            {"sheet", &sheet, 0, 5, "mm, thickness of the leather"},
                            {"lining", &lining, 0, 1, "colour under the holes"},
                            {"edge_colour", &edge_colour, 0, 1, "of the cut"},
                        });
  return all;
}

Mesostructure Perforated::build(int cells) const {
  const int across = std::max(1, static_cast<int>(std::lround(holes)));
  const int along = std::max(1, static_cast<int>(std::lround(hole_rows / 2))) * 2;
  const double size = static_cast<double>(mm), radius = 0.5 * static_cast<double>(diameter);
  const auto with_holes = [&](double u, double v) {
    Skin result = skin(u, v);
    // The nearest hole's middle; odd rows stand half a hole aside.
    double nearest = 1e9;
    const int row = static_cast<int>(std::floor(v * along));
    for (int r = row - 1; r <= row + 1; ++r) {
      const double shift = (r % 2 + 2) % 2 == 1 ? 0.5 : 0.0;
      const double x = u * across - shift;
      const double dx = (x - std::floor(x) - 0.5) * size / across;
      const double dy = (v * along - (r + 0.5)) * size / along;
      nearest = std::min(nearest, std::hypot(dx, dy));
    }
    // The punch draws the edge down a little before it cuts.
    const double rim = 0.22 * std::exp(-std::pow(std::max(0.0, nearest - radius) / 0.16, 1.5));
    if (nearest > radius) {
      result.height -= static_cast<double>(relief) * 0.45 * rim;
      return result;
    }
    const double wall = noise::smooth_step(radius - 0.12, radius, nearest);
    result.height =
        std::lerp(-static_cast<double>(relief * sheet), result.height - 0.1 * static_cast<double>(relief), wall);
    const double thread = 0.8 + 0.2 * noise::gradient(u, v, 90, 90, 71);
    result.colour = wall > 0 ? edge_colour : lining * static_cast<float>(thread);
    result.matter = 1;
    return result;
  };
  return {name, size, height_field(cells, size, with_holes), matters()};
}

}  // namespace vamp::acquire
