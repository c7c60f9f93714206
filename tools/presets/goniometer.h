#pragma once
// A virtual goniometer for height fields: what every texel sends from each of the 81 lights to each of the 81 views, as
// ReflectedCos. Texels are points of the surface itself: where another part hides one from a view, the part in front is
// seen. Direct light with shadows, one bounce gathered from the neighbourhood, a thin layer of stray fibres.
#include <array>
#include <functional>
#include <vector>

#include "tools/presets/surface.h"

namespace vamp::presets {

inline constexpr int kDirections = 81;
inline constexpr int kTexels = kSide * kSide;

// Share of the cosine-weighted hemisphere that each direction stands for; sums to pi (algorithms.md 3.3).
std::array<double, kDirections> direction_weights();

class Goniometer {
 public:
  explicit Goniometer(const Surface& surface);

  // Radiance of a texel for one view under all lights, in two parts: the coloured body with bounced light and stray
  // fibres, body[3 * light + channel], and the white finish, gloss[light]; `gloss` may be null.
  void measure(int texel, int view, float* body, float* gloss) const;

  // Share of the cosine-weighted hemisphere that a texel sees.
  float openness(int texel) const { return openness_[static_cast<size_t>(texel)]; }
  vec3 normal(int texel) const { return normals_[static_cast<size_t>(texel)]; }

 private:
  float finish(const Skin& skin, vec3 n, vec3 light, vec3 v) const;
  void find_shadows();
  void find_views();
  void gather_bounce();

  const Surface& surface_;
  std::vector<vec3> directions_;
  std::vector<vec3> normals_;
  std::vector<float> openness_;
  std::vector<uint8_t> lit_;   // [light][texel]: how many of kFine^2 points the light reaches
  std::vector<int32_t> seen_;  // [view][texel]: the texel that is seen instead
  std::vector<vec3> bounce_;   // [light][texel]: irradiance from the neighbourhood
};

// Runs work(i) for i in [0, count) on all cores; the result must not depend on the order.
void parallel(int count, const std::function<void(int)>& work);

}  // namespace vamp::presets
