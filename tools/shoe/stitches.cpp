#include "tools/shoe/stitches.h"

#include <cmath>

#include "tools/shoe/sweep.h"

namespace vamp::shoe {
namespace {

struct Place {
  Vec3 point, normal;
};

Mesh row(double length, const Stitch& stitch, const std::function<Place(double)>& place) {
  constexpr int kSteps = 5;
  const int count = std::max(1, static_cast<int>(length / stitch.pitch));
  const double pitch = length / count;
  Mesh all;
  for (int k = 0; k < count; ++k) {
    Sweep thread;
    thread.section = ellipse(stitch.radius, stitch.radius, 6);
    for (int i = 0; i <= kSteps; ++i) {
      const double t = double(i) / kSteps;
      const Place at = place((k + 0.5) * pitch + (t - 0.5) * stitch.length);
      // The ends dive into their holes.
      const double dive = std::pow(std::abs(2.0 * t - 1.0), 4.0);
      thread.path.push_back(at.point + stitch.radius * (0.75 - 1.9 * dive) * at.normal);
      thread.up.push_back(at.normal);
    }
    all.append(build(thread));
  }
  return all;
}

}  // namespace

Mesh stitch_row(const Curve& seam, const Panel& panel, const Last& last, const Stitch& stitch) {
  return row(seam.length(), stitch, [&](double s) {
    const Vec3 on = seam.at_length(s);
    const Vec3 n = last.normal(on);
    return Place{on + face_height(panel, on) * n, n};
  });
}

Mesh stitch_row(const Curve& seam, const Stitch& stitch) {
  return row(seam.length(), stitch, [&](double s) { return Place{seam.at_length(s), Vec3(0.0, 1.0, 0.0)}; });
}

}  // namespace vamp::shoe
