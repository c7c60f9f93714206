#pragma once
// A mesostructure from a picture of its heights, and one of its colours.
#include "engine/acquire/structure.h"
#include "engine/core/files.h"
#include "engine/image/image.h"

namespace vamp::acquire {

struct HeightMap : Structure {
  Image height;       // one channel, 0 to 1
  Image base_colour;  // R, G and B; empty: `colour` everywhere
  std::string name;
  float mm = 16;
  float relief = 1;  // mm from black to white
  vec3 colour{0.5f};
  float coat = 0;  // strength of a clear finish
  float roughness = 0.3f;
  float f0 = 0.05f;

  std::vector<Setting> settings() override;
  Mesostructure build(int cells) const override;
};

// `height`: a .png (or another picture) whose grey levels are heights, read as plain numbers; `colour`: the same
// place's colours, sRGB, or no path. Both cover the period, whatever their shape, row 0 at v = 0, and should repeat.
// bad_input: damaged, too large, of another kind.
Result<std::unique_ptr<Structure>> load_height_map(const fs::path& height, const fs::path& colour);

}  // namespace vamp::acquire
