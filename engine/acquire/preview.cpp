#include "engine/acquire/preview.h"

#include <cmath>
#include <numbers>

#include "engine/acquire/parallel.h"
#include "engine/core/direction_set.h"
#include "engine/core/progress.h"

namespace vamp::acquire {

Image preview(const Mesostructure& structure, int side, int samples, int threads, Progress& progress) {
  const auto towards = [](double theta, double phi) {
    constexpr double kDegree = std::numbers::pi / 180;
    return vec3(direction_of({theta * kDegree, phi * kDegree}));
  };
  // The lights of the two pictures, then those that fill the shadows.
  std::vector<vec3> lights = {towards(30, 230), towards(65, 230)};
  const DirectionSet all = ubo81();
  for (size_t i = 0; i < all.size(); i += 4) lights.emplace_back(all[i]);
  constexpr float kFill = 0.25f;
  const vec3 views[2] = {towards(0, 0), towards(45, 50)};
  const Goniometer goniometer(structure, lights, Shadows::tabulated, threads, &progress);

  Image image(2 * side, side, {"R", "G", "B"});
  parallel(threads, side, [&](int y) {
    std::vector<float> radiance(3 * lights.size());
    for (int x = 0; x < 2 * side; ++x) {
      const auto picture = static_cast<size_t>(x / side);
      std::fill(radiance.begin(), radiance.end(), 0.0f);
      Random random(hash_bits(static_cast<uint64_t>(x), static_cast<uint64_t>(y)));
      for (int s = 0; s < samples; ++s) {
        const vec2 place((static_cast<float>(x % side) + random.next()) / static_cast<float>(side),
                         1 - (static_cast<float>(y) + random.next()) / static_cast<float>(side));
        goniometer.trace(place, views[picture], random, radiance);
      }
      for (size_t c = 0; c < 3; ++c) {
        float fill = 0;
        for (size_t l = 2; l < lights.size(); ++l) fill += radiance[3 * l + c];
        fill /= static_cast<float>(lights.size() - 2);
        image.at(x, y, c) =
            std::numbers::pi_v<float> * (radiance[3 * picture + c] + kFill * fill) / static_cast<float>(samples);
      }
    }
    progress.fraction(static_cast<float>(y + 1) / static_cast<float>(side));
    return !progress.cancelled();
  });
  return image;
}

}  // namespace vamp::acquire
