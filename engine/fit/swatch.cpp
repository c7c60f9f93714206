#include "engine/fit/swatch.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>
#include <random>

#include "engine/fit/parallel.h"
#include "engine/material/tables.h"

namespace vamp::fit {
namespace {

constexpr double kPi = std::numbers::pi, kBallMm = 36, kGround = 0.22;
constexpr int kGrid = 2;  // samples of a pixel, squared

struct Lamp {
  dvec3 direction;
  double spread;  // radius of its disk at distance 1
  double irradiance;
  int samples;
};
const std::array<Lamp, 4> kLamps = {{{glm::normalize(dvec3(-0.5, 0.6, 0.8)), 0.17, 2.7, 8},
                                     {glm::normalize(dvec3(0.85, 0.15, 0.55)), 0.6, 0.55, 4},
                                     {glm::normalize(dvec3(0.45, 0.6, -0.25)), 0.3, 0.8, 3},
                                     {glm::normalize(dvec3(0, 1, 0.25)), 0.9, 0.5, 4}}};

using Draw = std::uniform_real_distribution<double>;

// Shoulder above 0.75, so that highlights keep their shape.
float shown(double value) {
  constexpr double kStart = 0.75;
  if (value < kStart) return static_cast<float>(std::max(value, 0.0));
  return static_cast<float>(1 - (1 - kStart) * std::exp(-(value - kStart) / (1 - kStart)));
}

class Ball {
 public:
  explicit Ball(const Spmm& spmm) : spmm_(spmm), edited_(edited_tables(spmm, {})) {
    if (!spmm.residual.records.empty())
      if (auto found = triangulate(spmm.residual.directions, "")) directions_ = std::move(*found);
  }

  // Radiance towards the viewer at (x, y) of the ball, from -1 to 1 inside it.
  dvec3 radiance(double x, double y, std::mt19937& random) const {
    Draw draw;
    const dvec3 n(x, y, std::sqrt(std::max(0.0, 1 - x * x - y * y)));
    // Longitude and latitude about the upright axis: the grain runs round the ball as on a turned part.
    const dvec3 t = glm::normalize(dvec3(n.z, 0, -n.x)), b = glm::cross(n, t);
    const double latitude = std::asin(std::clamp(y, -1.0, 1.0)), longitude = std::atan2(x, n.z);
    const double mm{spmm_.mm_per_texel};
    const int column = wrapped(longitude * kBallMm / 2 * std::cos(latitude * 0.6) / mm + draw(random), spmm_.width);
    const int row = wrapped(latitude * kBallMm / 2 / mm + draw(random), spmm_.height);
    const auto local = [&](dvec3 w) { return dvec3(glm::dot(w, t), glm::dot(w, b), glm::dot(w, n)); };
    const dvec3 wo = local({0, 0, 1});
    const auto value = [&](dvec3 wi) {
      return wi.z > 0 ? evaluate(spmm_, edited_, kMaxResidualTerms, directions_, column, row, wi, wo) : dvec3(0);
    };
    dvec3 sum(0);
    for (const Lamp& lamp : kLamps) {
      const dvec3 side = glm::normalize(glm::cross(lamp.direction, dvec3(0.1, 0.9, 0.2))),
                  other = glm::cross(lamp.direction, side);
      for (int i = 0; i < lamp.samples; ++i) {
        const double phi = 2 * kPi * (i + draw(random)) / lamp.samples, r = lamp.spread * std::sqrt(draw(random));
        sum += value(local(glm::normalize(lamp.direction + side * (r * std::cos(phi)) + other * (r * std::sin(phi))))) *
               (lamp.irradiance / lamp.samples);
      }
    }
    // Even light from all sides; more samples towards the rim, where a finish mirrors it.
    const int even = 24 + static_cast<int>(40 * std::pow(1 - n.z, 3));
    for (int i = 0; i < even; ++i) {
      const double z = draw(random), phi = 2 * kPi * draw(random), s = std::sqrt(1 - z * z);
      sum += value({s * std::cos(phi), s * std::sin(phi), z}) * (2 * kPi * 0.12 / even);
    }
    return sum;
  }

 private:
  static int wrapped(double position, int period) {
    const auto i = static_cast<int>(std::floor(position));
    return ((i % period) + period) % period;
  }

  const Spmm& spmm_;
  EditedTables edited_;
  DirectionTables directions_;
};

// The ground behind the ball, with its soft shadow below.
double ground(double x, double y) {
  const double shade = 1 - 0.45 * std::exp(-(std::pow(x / 0.9, 2) + std::pow((y + 1.02) / 0.16, 2)));
  return kGround * shade * (1 - 0.25 * (x * x + y * y - 1));
}

}  // namespace

Image material_swatch(const Spmm& spmm, int side, int threads) {
  const Ball ball(spmm);
  Image image(side, side, {"R", "G", "B"});
  Worker{std::max(threads, 1), nullptr}.each(static_cast<size_t>(side), [&](size_t line) {
    const auto row = static_cast<int>(line);
    std::mt19937 random(static_cast<uint32_t>(row));
    Draw draw;
    for (int column = 0; column < side; ++column) {
      dvec3 sum(0);
      for (int s = 0; s < kGrid * kGrid; ++s) {
        const double x = (column + (s % kGrid + draw(random)) / kGrid) / side * 2.2 - 1.1;
        const double y = 1.1 - (row + (s / kGrid + draw(random)) / kGrid) / side * 2.2;
        sum += x * x + y * y < 1 ? ball.radiance(x, y, random) : dvec3(ground(x, y));
      }
      for (int c = 0; c < 3; ++c) image.at(column, row, static_cast<size_t>(c)) = shown(sum[c] / (kGrid * kGrid));
    }
  });
  return image;
}

}  // namespace vamp::fit
