#include "engine/acquire/leather.h"

#include <cmath>
#include <numbers>

#include "engine/acquire/noise.h"

namespace vamp::acquire {

std::vector<Setting> Leather::settings() {
  return {
      {"mm", &mm, 1, 200, "size of the period"},
      {"plates", &plates, 2, 100, "plates across the period"},
      {"relief", &relief, 0, 10, "factor of all heights"},
      {"plate_height", &plate_height, 0, 5, "mm from crease to plate"},
      {"crease_width", &crease_width, 0.01f, 1, "share of a plate"},
      {"wrinkles", &wrinkles, 0, 5, "mm, height of the finer wrinkles"},
      {"pores", &pores, 0, 1, "share of the places where one could be"},
      {"pore_depth", &pore_depth, 0, 5, "mm"},
      {"mottling", &mottling, 0, 1, "how uneven the colour is"},
      {"colour", &colour, 0, 1, "of the plates"},
      {"crease_colour", &crease_colour, 0, 1, "of creases and pores"},
      {"coat", &coat, 0, 1, "strength of the finish; 0 takes it off"},
      {"roughness", &roughness, 0.03f, 1, "width of the finish's highlight"},
      {"f0", &f0, 0, 1, "reflection of the finish, seen head-on"},
      {"fuzz", &fuzz, 0, 1.5f, "spread of tiny slopes of the body, radians"},
  };
}

Skin Leather::skin(double u, double v) const {
  using namespace noise;
  const int count = std::max(2, static_cast<int>(std::lround(plates)));
  // Sites on a straight lattice would show; a slow warp bends it.
  const double bend = 0.55 / count;
  const double wu = u + bend * fractal(u, v, count / 2 + 1, count / 2 + 1, 2, 11);
  const double wv = v + bend * fractal(u, v, count / 2 + 1, count / 2 + 1, 2, 12);
  const CellPoint plate = cells(wu, wv, count, count, 0.95, 1);
  const CellPoint wrinkle =
      cells(wu + 0.3 * bend * gradient(u, v, 3 * count, 3 * count, 13), wv, 5 * count / 2, 5 * count / 2, 0.95, 2);
  const CellPoint pore = cells(u, v, 2 * count, 2 * count, 0.9, 3);

  // Creases differ in depth along their way, and fade out here and there.
  const double strength = std::clamp(0.72 + 0.5 * fractal(u, v, count, count, 2, 14), 0.2, 1.0);
  const double in_crease = strength * std::exp(-std::pow(plate.edge / static_cast<double>(crease_width), 1.4));
  const double dome = 0.35 * smooth_step(0, 0.55, plate.edge);
  const double fine = std::exp(-std::pow(wrinkle.edge / 0.14, 1.4)) * (0.5 + 0.5 * hash01(wrinkle.id, 0, 15));
  const bool has_pore = hash01(pore.id, 1, 16) < static_cast<double>(pores);
  const double in_pore = has_pore ? 1 - smooth_step(0.08, 0.24, pore.centre) : 0;
  const double tiny = fractal(u, v, 9 * count, 9 * count, 2, 17);

  Skin skin;
  skin.height = static_cast<double>(relief) *
                (static_cast<double>(plate_height) * (dome - in_crease) +
                 static_cast<double>(wrinkles) * (0.25 * tiny - fine) - static_cast<double>(pore_depth) * in_pore);
  const double dark =
      std::clamp(0.9 * in_crease + 0.25 * fine * static_cast<double>(wrinkles) / 0.03 + 0.8 * in_pore, 0.0, 1.0);
  const double uneven = 1 + static_cast<double>(mottling) *
                                (0.8 * fractal(u, v, 3, 3, 3, 18) + 0.5 * (hash01(plate.id, 2, 19) - 0.5) + 0.3 * tiny);
  skin.colour = glm::clamp((colour + (crease_colour - colour) * static_cast<float>(dark)) * static_cast<float>(uneven),
                           0.0f, 1.0f);
  skin.matter = in_pore > 0.5 ? 1 : 0;
  return skin;
}

std::vector<Matter> Leather::matters() const {
  Matter finished, bare;
  if (fuzz > 0) finished.body = {Model::oren_nayar, kOrenNayarQualitative, {1, fuzz}};
  bare.body = finished.body;
  finished.coat = {Model::cook_torrance, kCookTorranceModernSchlick, {1, roughness, f0}};
  finished.coat_colour = vec3(coat);
  return {finished, bare};
}

Mesostructure Leather::build(int cells) const {
  return {name, static_cast<double>(mm),
          height_field(cells, static_cast<double>(mm), [this](double u, double v) { return skin(u, v); }), matters()};
}

}  // namespace vamp::acquire
