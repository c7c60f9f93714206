#include "engine/acquire/emboss.h"

#include <algorithm>
#include <cmath>

#include "engine/acquire/height_field.h"
#include "engine/acquire/noise.h"

namespace vamp::acquire {

std::vector<Setting> Emboss::settings() {
  return {
      {"mm", &mm, 1, 200, "size of the period"},
      {"columns", &columns, 1, 60, "scales across the period"},
      {"rows", &rows, 2, 60, "scales along it, rounded to an even number"},
      {"relief", &relief, 0, 5, "factor of all heights"},
      {"depth", &depth, 0, 5, "mm, of the grooves"},
      {"groove", &groove, 0.01f, 0.5f, "width of the grooves, share of a scale"},
      {"irregular", &irregular, 0, 1, "0: bricks"},
      {"wrinkles", &wrinkles, 0, 2, "mm, on the scales"},
      {"colour", &colour, 0, 1, "of the scales"},
      {"groove_colour", &groove_colour, 0, 1, "between them"},
      {"coat", &coat, 0, 1, "strength of the glaze; 0 takes it off"},
      {"roughness", &roughness, 0.03f, 1, "width of the glaze's highlight"},
      {"f0", &f0, 0, 1, "reflection of the glaze, seen head-on"},
  };
}

Mesostructure Emboss::build(int cells) const {
  using namespace noise;
  const int across = std::max(1, static_cast<int>(std::lround(columns)));
  const int along = std::max(1, static_cast<int>(std::lround(rows / 2))) * 2;
  const double high = static_cast<double>(relief);
  Matter glazed;
  glazed.coat = {Model::cook_torrance, kCookTorranceModernSchlick, {1, roughness, f0}};
  glazed.coat_colour = vec3(coat);
  const auto skin = [&](double u, double v) {
    const double bend = 0.05 / across;
    const double wu = u + bend * fractal(u, v, 2 * across, 2 * along, 2, 51);
    const double wv = v + bend * fractal(u, v, 2 * across, 2 * along, 2, 52);
    const CellPoint scale = noise::cells(wu, wv, across, along, static_cast<double>(irregular), 53, 0.5);
    const double width = static_cast<double>(groove);
    // A rounded shoulder beside the groove, then a pillow; every scale stands a little higher or lower.
    const double shoulder = 1 - std::exp(-std::pow(scale.edge / width, 2.0));
    const double pillow = smooth_step(0, 0.6, scale.edge);
    // Wrinkles cross the scales and die out on their tops.
    const double crossing = gradient(u, v, 5 * across, 2 * along, 54);
    const CellPoint crackle = noise::cells(wu, wv, 5 * across, 4 * along, 0.9, 55);
    const double crack = std::exp(-std::pow(crackle.edge / 0.1, 1.5)) * (1 - 0.75 * pillow) * shoulder;
    Skin result;
    result.height = high * (static_cast<double>(depth) *
                                (0.62 * shoulder + 0.38 * pillow + 0.12 * (hash01(scale.id, 1, 56) - 0.5) * shoulder) +
                            static_cast<double>(wrinkles) * (crossing * shoulder - 1.4 * crack +
                                                             0.12 * fractal(u, v, 16 * across, 12 * along, 2, 57)));
    const auto dark = static_cast<float>(std::clamp(1 - shoulder * (0.55 + 0.45 * pillow) + 0.35 * crack, 0.0, 1.0));
    const auto uneven =
        static_cast<float>(1 + 0.25 * (hash01(scale.id, 2, 58) - 0.5) + 0.12 * fractal(u, v, 4, 4, 3, 59));
    result.colour = glm::clamp((colour + (groove_colour - colour) * dark) * uneven, 0.0f, 1.0f);
    return result;
  };
  return {name, static_cast<double>(mm), height_field(cells, static_cast<double>(mm), skin), {glazed}};
}

}  // namespace vamp::acquire
