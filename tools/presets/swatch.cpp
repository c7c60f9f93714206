#include "tools/presets/swatch.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tools/presets/goniometer.h"
#include "tools/presets/noise.h"

namespace vamp::presets {
namespace {

constexpr double kPi = std::numbers::pi;

double dot(dvec3 a, dvec3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
dvec3 unit(dvec3 v) { return v / std::sqrt(dot(v, v)); }
dvec3 cross(dvec3 a, dvec3 b) { return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x}; }

struct Lamp {
  dvec3 direction;
  double spread;  // radius of its disk at distance 1
  double irradiance;
  int samples;
};

constexpr vec3 kGround(0.22f);

// Shoulder above 0.75, so that highlights keep their shape.
float shown(double value) {
  const double start = 0.75;
  if (value < start) return static_cast<float>(std::max(value, 0.0));
  return static_cast<float>(1 - (1 - start) * std::exp(-(value - start) / (1 - start)));
}

}  // namespace

Swatch::Swatch(const Spmm& spmm, const EditLayer& edits)
    : spmm_(spmm),
      edited_(edited_tables(spmm, edits)),
      terms_(edits.residual_terms),
      directions_(triangulate(spmm.residual.directions, "").value()) {}

// y is the frame's second axis, which points to falling v.
dvec3 Swatch::value(double x_mm, double y_mm, dvec3 wi, dvec3 wo) const {
  const double mm{spmm_.mm_per_texel};
  const auto texel = [](double position, int period) {
    const auto i = static_cast<int>(std::floor(position));
    return ((i % period) + period) % period;
  };
  return evaluate(spmm_, edited_, terms_, directions_, texel(x_mm / mm, spmm_.width), texel(-y_mm / mm, spmm_.height),
                  wi, wo);
}

Image Swatch::ball(int side, double ball_mm) const {
  Image image(side, side, {"R", "G", "B"});
  const std::vector<Lamp> lamps = {{unit({-0.5, 0.6, 0.8}), 0.17, 2.7, 8},
                                   {unit({0.85, 0.15, 0.55}), 0.6, 0.55, 4},
                                   {unit({0.45, 0.6, -0.25}), 0.3, 0.8, 3},
                                   {unit({0.0, 1.0, 0.25}), 0.9, 0.5, 4}};
  parallel(side, [&](int row) {
    for (int column = 0; column < side; ++column) {
      dvec3 sum(0);
      constexpr int kGrid = 3;
      for (int s = 0; s < kGrid * kGrid; ++s) {
        const auto random = [&](int k) { return hash01(row * 4096 + column, s * 256 + k, 5); };
        const double x = (column + (s % kGrid + random(0)) / kGrid) / side * 2.2 - 1.1;
        const double y = 1.1 - (row + (s / kGrid + random(1)) / kGrid) / side * 2.2;
        const double r2 = x * x + y * y;
        if (r2 >= 1) {
          // A ground behind the ball, with its soft shadow below.
          const double shade = 1 - 0.45 * std::exp(-(std::pow(x / 0.9, 2) + std::pow((y + 1.02) / 0.16, 2)));
          sum += dvec3(kGround) * shade * (1 - 0.25 * (r2 - 1));
          continue;
        }
        const dvec3 n(x, y, std::sqrt(1 - r2)), view(0, 0, 1);
        // Longitude and latitude about the upright axis: the grain runs round the ball as on a turned part.
        const double radius = ball_mm / 2, latitude = std::asin(std::clamp(y, -1.0, 1.0));
        const double longitude = std::atan2(x, n.z);
        const dvec3 t = unit(dvec3(n.z, 0, -n.x)), b = cross(n, t);
        const double mm{spmm_.mm_per_texel};
        const double u = longitude * radius * std::cos(latitude * 0.6) + (random(2) - 0.5) * mm;
        const double v = latitude * radius + (random(3) - 0.5) * mm;
        const auto local = [&](dvec3 w) { return dvec3(dot(w, t), dot(w, b), dot(w, n)); };
        int k = 4;
        for (const Lamp& lamp : lamps)
          for (int i = 0; i < lamp.samples; ++i) {
            const dvec3 side1 = unit(cross(lamp.direction, dvec3(0.1, 0.9, 0.2))), side2 = cross(lamp.direction, side1);
            const double phi = 2 * kPi * (i + random(k)) / lamp.samples, rr = lamp.spread * std::sqrt(random(k + 1));
            k += 2;
            const dvec3 wi = unit(lamp.direction + side1 * (rr * std::cos(phi)) + side2 * (rr * std::sin(phi)));
            sum += value(u, v, local(wi), local(view)) * (lamp.irradiance / lamp.samples);
          }
        // Even light from all sides; towards the rim, where the finish mirrors it, more of it.
        const int even = 4 + static_cast<int>(40 * std::pow(1 - n.z, 3));
        for (int i = 0; i < even; ++i, k += 2) {
          const double z = random(k), phi = 2 * kPi * random(k + 1), ss = std::sqrt(1 - z * z);
          sum += value(u, v, {ss * std::cos(phi), ss * std::sin(phi), z}, local(view)) * (2 * kPi * 0.12 / even);
        }
      }
      for (int c = 0; c < 3; ++c) image.at(column, row, static_cast<size_t>(c)) = shown(sum[c] / 9);
    }
  });
  return image;
}

Image Swatch::patch(int side, double mm, double view_degrees, double light_degrees, double light_azimuth) const {
  Image image(side, side, {"R", "G", "B"});
  const auto angle = [](double degrees) { return degrees * kPi / 180; };
  const dvec3 view(0, -std::sin(angle(view_degrees)), std::cos(angle(view_degrees)));
  // A lamp near the patch: the highlight falls inside the picture.
  const double distance = 2.2 * mm;
  const dvec3 lamp(std::sin(angle(light_degrees)) * std::sin(angle(light_azimuth)) * distance,
                   std::sin(angle(light_degrees)) * std::cos(angle(light_azimuth)) * distance,
                   std::cos(angle(light_degrees)) * distance);
  parallel(side, [&](int row) {
    for (int column = 0; column < side; ++column) {
      dvec3 sum(0);
      for (int s = 0; s < 4; ++s) {
        const auto random = [&](int k) { return hash01(row * 4096 + column, s * 64 + k, 6); };
        const double x = ((column + random(0)) / side - 0.5) * mm, y = (0.5 - (row + random(1)) / side) * mm;
        const double mm_texel{spmm_.mm_per_texel};
        dvec3 wi(lamp.x + (random(2) - 0.5) * 0.2 * distance - x, lamp.y + (random(3) - 0.5) * 0.2 * distance - y,
                 lamp.z);
        const double d2 = dot(wi, wi);
        wi = unit(wi);
        sum += value(x + (random(4) - 0.5) * mm_texel, y + (random(5) - 0.5) * mm_texel, wi, view) *
               (3.2 * distance * distance / d2);
      }
      for (int c = 0; c < 3; ++c) image.at(column, row, static_cast<size_t>(c)) = shown(sum[c] / 4);
    }
  });
  return image;
}

}  // namespace vamp::presets
