#include "tools/shoe/last.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace vamp::shoe {
namespace {

constexpr double kToeTip = 292.0;    // front end of the bottom
constexpr double kToeStart = 192.0;  // where the toe begins to close
constexpr double kHeelStart = 62.0;  // where the heel begins to close
constexpr double kToePower = 2.75;   // > 2 keeps the field C2 where the ends begin
constexpr double kHeelPower = 2.4;
constexpr double kSidePower = 2.15;  // 2 would be an ellipse; more is boxier
constexpr double kTopPower = 2.3;
constexpr double kBulge = 2.6;  // how far the walls lean out above the feather
constexpr double kBulgeHeight = 15.0;

}  // namespace

// Tables of a men's derby of French size 42, heel 24 mm: the outer surface is this last plus 1.6 to 5 mm of leather.
Last::Last()
    : feather_(
          {{0, 33}, {40, 31.6}, {80, 28.6}, {120, 22.4}, {160, 15.8}, {200, 12.9}, {230, 13.6}, {260, 17}, {295, 24}}),
      lateral_({{0, 30},
                {40, 31},
                {75, 31.5},
                {110, 34.5},
                {150, 40.5},
                {180, 45},
                {205, 46},
                {230, 43},
                {255, 37.5},
                {290, 29}}),
      medial_({{0, 30},
               {40, 30.5},
               {75, 28.5},
               {110, 24.5},
               {150, 28.5},
               {180, 37},
               {205, 43},
               {230, 45},
               {255, 44.5},
               {290, 41.5}}),
      ridge_height_({{0, 165},
                     {60, 158},
                     {85, 133},
                     {105, 107},
                     {125, 89},
                     {150, 73},
                     {175, 59},
                     {200, 47.5},
                     {230, 37.5},
                     {260, 32},
                     {295, 29}}),
      ridge_shift_({{0, 0}, {80, -1}, {120, -4}, {160, -7}, {200, -5}, {240, -1.5}, {290, 0}}),
      back_({{-6, 14.5}, {0, 13}, {10, 10.8}, {22, 10}, {38, 11.6}, {55, 14.8}, {75, 17.5}}) {}

double Last::centre(double x, double above) const {
  const double bottom = 0.5 * (lateral_(x) - medial_(x));
  return bottom + ridge_shift_(x) * smooth_step(0.0, ridge_height_(x), above);
}

double Last::width(double x, double above) const {
  const double t = above / kBulgeHeight;
  return 0.5 * (lateral_(x) + medial_(x)) + kBulge * t * std::exp(1.0 - t);
}

double Last::ends(double x, double above) const {
  const double back = back_(above);
  const double toe = std::max(0.0, (x - kToeStart) / (kToeTip - kToeStart));
  const double heel = std::max(0.0, (kHeelStart - x) / (kHeelStart - back));
  return std::pow(toe, kToePower) + std::pow(heel, kHeelPower);
}

double Last::field(const Vec3& p) const {
  const double above = p.y - feather_(p.x);
  const double side = std::abs(p.z - centre(p.x, above)) / width(p.x, above);
  const double top = std::max(0.0, above) / ridge_height_(p.x);
  return std::pow(side, kSidePower) + std::pow(top, kTopPower) + ends(p.x, above) - 1.0;
}

namespace {

Vec3 gradient(const Last& last, const Vec3& p) {
  constexpr double h = 1e-3;
  Vec3 g;
  for (int axis = 0; axis < 3; ++axis) {
    Vec3 step(0.0);
    step[axis] = h;
    g[axis] = (last.field(p + step) - last.field(p - step)) / (2.0 * h);
  }
  return g;
}

}  // namespace

Vec3 Last::normal(const Vec3& p) const { return glm::normalize(gradient(*this, p)); }

Vec3 Last::project(Vec3 p) const {
  for (int i = 0; i < 20; ++i) {
    const Vec3 g = gradient(*this, p);
    const Vec3 step = field(p) / glm::dot(g, g) * g;
    p -= step;
    if (glm::dot(step, step) < 1e-16) break;
  }
  return p;
}

Vec3 Last::lifted(const Vec3& p, double offset) const {
  const Vec3 on = project(p);
  return on + offset * normal(on);
}

double Last::height(const Vec3& p) const {
  const Vec3 on = project(p);
  return glm::dot(p - on, normal(on));
}

Vec3 Last::wall(double x, double above, double side) const {
  const double rest = 1.0 - std::pow(std::max(0.0, above) / ridge_height_(x), kTopPower) - ends(x, above);
  const double reach = std::pow(std::max(0.0, rest), 1.0 / kSidePower);
  return {x, feather_(x) + above, centre(x, above) + side * width(x, above) * reach};
}

namespace {

// The zero of an increasing function between a and b.
double bisect(double a, double b, const std::function<double(double)>& f) {
  for (int i = 0; i < 60; ++i) {
    const double m = 0.5 * (a + b);
    (f(m) > 0 ? b : a) = m;
  }
  return 0.5 * (a + b);
}

}  // namespace

Vec3 Last::heel(double z, double above) const {
  const auto point = [&](double x) { return Vec3(x, feather_(x) + above, z); };
  return point(-bisect(-kHeelStart, 0.0, [&](double minus_x) { return field(point(-minus_x)); }));
}

Vec3 Last::roof(double x, double from_ridge) const {
  const double z = centre(x, ridge_height_(x)) + from_ridge;
  const auto point = [&](double above) { return Vec3(x, feather_(x) + above, z); };
  return point(bisect(0.0, 1.2 * ridge_height_(x), [&](double above) { return field(point(above)); }));
}

Curve Last::outline(double above) const {
  constexpr int kSamples = 2400;
  const Vec3 middle(150.0, 0.0, 0.0);
  const auto at = [&](double turn) {
    // A stretched circle about the middle, cast towards a segment inside: every direction meets the outline once.
    const double x = -std::cos(turn), z = -std::sin(turn);
    const Vec3 from = middle + Vec3(90.0 * x, 0.0, 0.0);
    const double reach = bisect(0.0, 90.0, [&](double r) {
      const double px = from.x + r * x;
      return field({px, feather_(px) + above, centre(px, above) + r * z});
    });
    const double px = from.x + reach * x;
    return Vec3(px, feather_(px) + above, centre(px, above) + reach * z);
  };
  Polyline points;
  for (int i = 0; i <= kSamples; ++i) points.push_back(at(2.0 * std::numbers::pi * i / kSamples));
  return Curve(Curve(std::move(points)).evenly(kSamples + 1));
}

Curve Last::through(const Polyline& points) const {
  return spline(points).mapped([&](const Vec3& p) { return project(p); });
}

}  // namespace vamp::shoe
