#pragma once
// A measured sky or studio: HDR lat-long map with the table that draws directions in proportion to its luminance.
#include <cstdint>
#include <filesystem>
#include <memory>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/vec.h"

namespace vamp {

struct Image;

// The map is constant within a texel, for looking up and for sampling, so that pdf and radiance agree exactly.
// Direction to texture coordinates (before rotation): u = 0.5 + atan2(x, -z) / (2 pi), v = acos(y) / pi; the middle of
// the picture lies along -Z, its right half towards +X, its top row up (+Y). `rotation` turns the map about +Y by the
// right-hand rule: look up R_y(-rotation) * direction.
struct Environment {
  // Alias table (Vose 1991): draw cell i uniformly, keep it when a second number is below `keep`, else take `other`.
  struct Cell {
    float keep = 1;
    uint32_t other = 0;
  };

  uint32_t width = 0;        // at most 4096
  uint32_t height = 0;       // at most 2048
  std::vector<vec4> texels;  // rgb radiance, a: pdf per solid angle of sample(); row 0 is the top
  std::vector<Cell> cells;   // one for each texel

  struct Sample {
    vec3 direction{0, 1, 0};
    vec3 radiance{0};
    float pdf = 0;  // per solid angle
  };
  // u: four numbers in [0, 1): cell, alias, then azimuth and cosine inside the texel.
  Sample sample(const vec4& u, float rotation_radians = 0) const;

  // Radiance and pdf along a unit direction.
  vec4 lookup(const vec3& direction, float rotation_radians = 0) const;

  // Integral of luminance over the sphere divided by 4 pi.
  double mean_luminance = 0;
};

// Any image that engine/image reads, width : height about 2 : 1. Negative or non-finite texels are an error that names
// the texel. Maps beyond 4096 x 2048 are averaged down.
Result<std::shared_ptr<const Environment>> load_environment(const std::filesystem::path& path);

// The same from linear RGB texels in memory (row 0 on top); `file` is for messages.
Result<std::shared_ptr<const Environment>> make_environment(uint32_t width, uint32_t height, std::vector<vec3> radiance,
                                                            std::string_view file);

}  // namespace vamp
