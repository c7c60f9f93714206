#include "engine/acquire/height_map.h"

#include <algorithm>
#include <cmath>

#include "engine/acquire/height_field.h"
#include "engine/image/load.h"

namespace vamp::acquire {
namespace {

// Between the four pixels around a point of the period, pixels' middles being where they are exact.
float sample(const Image& image, double u, double v, size_t channel) {
  // The top row of the picture is the top row of the BTF.
  const double x = u * image.width - 0.5, y = (1 - v) * image.height - 0.5;
  const double x0 = std::floor(x), y0 = std::floor(y);
  const auto at = [&](double i, double j) {
    const auto wrap = [](double k, int size) { return (static_cast<int>(k) % size + size) % size; };
    return static_cast<double>(image.at(wrap(i, image.width), wrap(j, image.height), channel));
  };
  return static_cast<float>(std::lerp(std::lerp(at(x0, y0), at(x0 + 1, y0), x - x0),
                                      std::lerp(at(x0, y0 + 1), at(x0 + 1, y0 + 1), x - x0), y - y0));
}

}  // namespace

std::vector<Setting> HeightMap::settings() {
  return {
      {"mm", &mm, 0.1f, 1000, "size of the period"},
      {"relief", &relief, 0, 100, "mm from black to white"},
      {"colour", &colour, 0, 1, "where there is no picture of it"},
      {"coat", &coat, 0, 1, "strength of a clear finish; 0 takes it off"},
      {"roughness", &roughness, 0.03f, 1, "width of the finish's highlight"},
      {"f0", &f0, 0, 1, "reflection of the finish, seen head-on"},
  };
}

Mesostructure HeightMap::build(int cells) const {
  const auto skin = [&](double u, double v) {
    Skin result;
    result.height = static_cast<double>(relief * sample(height, u, v, 0));
    result.colour = colour;
    if (base_colour.width > 0)
      for (int c = 0; c < 3; ++c)
        result.colour[c] = std::clamp(sample(base_colour, u, v, static_cast<size_t>(c)), 0.0f, 1.0f);
    return result;
  };
  Matter matter;
  matter.coat = {Model::cook_torrance, kCookTorranceModernSchlick, {1, roughness, f0}};
  matter.coat_colour = vec3(coat);
  return {name, static_cast<double>(mm), height_field(cells, static_cast<double>(mm), skin), {matter}};
}

Result<std::unique_ptr<Structure>> load_height_map(const fs::path& height, const fs::path& colour) {
  auto map = std::make_unique<HeightMap>();
  map->name = height.stem().string();
  VAMP_TRY(const Image levels, load_image(height, ColourSpace::linear));
  // Of a coloured picture the mean of red, green and blue.
  map->height = Image(levels.width, levels.height, {"Y"});
  const size_t channels = levels.channels.size() >= 3 ? 3 : 1;
  for (int y = 0; y < levels.height; ++y)
    for (int x = 0; x < levels.width; ++x) {
      float sum = 0;
      for (size_t c = 0; c < channels; ++c) sum += levels.at(x, y, c);
      map->height.at(x, y, 0) = std::clamp(sum / static_cast<float>(channels), 0.0f, 1.0f);
    }
  if (!colour.empty()) {
    VAMP_TRY(const Image picture, load_image(colour));
    VAMP_TRY(map->base_colour, colour_of(picture, "", colour.string()));
  }
  return map;
}

}  // namespace vamp::acquire
