#include "tools/shoe/laces.h"

#include <cmath>
#include <numbers>

#include "tools/shoe/hardware.h"
#include "tools/shoe/sweep.h"

namespace vamp::shoe {
namespace {

constexpr double kHalfWidth = 1.75, kHalfHeight = 1.2;  // of the cord, mm
constexpr double kUnder = kHalfHeight + 0.1;  // height of the cord's middle on the tongue, whose face is the last

class Cord {
 public:
  Cord(const Upper& upper, const Last& last) : upper_(upper), last_(last) {}

  // The height of the uppermost layer over the last, beside the gap between the facings.
  double face(const Vec3& on, int side) const { return face_height(upper_.quarter[static_cast<size_t>(side)], on); }
  Vec3 eyelet(int side, int row) const { return eyelet_place(upper_, last_, side, row); }

  // A tube along a spline through points.
  Mesh tube(const Polyline& points, bool round_start, bool round_end, double fat = 1.0) const {
    Sweep sweep;
    const Curve path = spline(points, 2000);
    const int count = std::max(8, static_cast<int>(path.length() / 0.9));
    sweep.path = path.evenly(count);
    Vec3 up = last_.normal(last_.project(sweep.path[0]));
    for (int i = 0; i < count; ++i) {
      // Carry the frame along, turning the flat side towards the leather where the cord lies on it.
      const Vec3 tangent = path.tangent(double(i) / (count - 1));
      const Vec3 normal = last_.normal(last_.project(sweep.path[static_cast<size_t>(i)]));
      const Vec3 flat = normal - glm::dot(normal, tangent) * tangent;
      up -= glm::dot(up, tangent) * tangent;
      up = glm::normalize(glm::normalize(up) + 0.15 * (glm::dot(up, flat) < 0 ? -flat : flat));
      sweep.up.push_back(up);
    }
    sweep.section = ellipse(kHalfWidth * fat, kHalfHeight * fat, 14);
    sweep.round_start = round_start;
    sweep.round_end = round_end;
    return build(sweep);
  }

  // From the middle below the first pair of eyelets up to the last one; the cord comes up through every eyelet, runs
  // over the facing, crosses its partner on the tongue and passes under the other facing.
  Polyline crossing(int side) const {
    Polyline points;
    const auto put = [&](const Vec3& at, double height) { points.push_back(last_.lifted(at, height)); };
    put(glm::mix(eyelet(0, 0), eyelet(1, 0), 0.5), kUnder);
    put(glm::mix(eyelet(side, 0), eyelet(1 - side, 0), 0.25), kUnder);
    for (int row = 0; row < kEyelets; ++row) {
      const Vec3 here = eyelet(side, row);
      const double top = face(here, side);
      const Vec3 target = row + 1 < kEyelets ? eyelet(1 - side, row + 1) : knot_foot();
      const Vec3 step = glm::normalize(target - here);
      // Up through the hole.
      put(here - 2.4 * inward(here), kUnder - 0.2);
      put(here - 0.5 * inward(here), top - 1.2);
      put(here - 0.1 * inward(here), top + 0.4);
      put(here + 1.6 * step, top + kHalfHeight + 0.75);
      if (row + 1 == kEyelets) break;
      // Over this facing, across the tongue, under the other.
      const double span = glm::distance(here, target);
      const bool over = (row + side) % 2 == 0;
      put(here + 0.24 * span * step, top + kHalfHeight + 0.5);
      put(here + 0.38 * span * step, top + (over ? kHalfHeight : -0.6));
      put(here + 0.5 * span * step, kUnder + (over ? 2.0 * kHalfHeight + 0.6 : 0.5));
      put(here + 0.64 * span * step, kUnder + 0.1);
      put(here + 0.8 * span * step, kUnder - 0.1);
      side = 1 - side;
    }
    const Vec3 end = points.back();
    const Vec3 knot = knot_middle();
    points.push_back(glm::mix(end, knot, 0.5) + 0.8 * last_.normal(end));
    points.push_back(knot);
    return points;
  }

  Vec3 knot_foot() const { return last_.project(glm::mix(eyelet(0, kEyelets - 1), eyelet(1, kEyelets - 1), 0.5)); }
  Vec3 knot_middle() const { return last_.lifted(knot_foot(), 5.2); }

  // A point beside the knot, `side` mm outwards along z and `down` mm towards the toe, `height` over the upper.
  Vec3 beside_knot(double side, double down, double height) const {
    // Walked over the last in short steps, so that the distances are those along the leather.
    constexpr int kSteps = 16;
    Vec3 on = knot_foot();
    for (int step = 0; step < kSteps; ++step) {
      const Vec3 n = last_.normal(on);
      const Vec3 to_toe = glm::normalize(glm::cross(n, Vec3(0.0, 0.0, 1.0)));
      on = last_.project(on + (side * glm::cross(to_toe, n) + down * to_toe) / double(kSteps));
    }
    const double layers = face(on, side > 0 ? 1 : 0);
    return last_.lifted(on, layers + kHalfHeight + height);
  }

 private:
  // Towards the middle of the shoe.
  Vec3 inward(const Vec3& at) const {
    const Vec3 to = glm::mix(eyelet(0, 2), eyelet(1, 2), 0.5) - at;
    return {0.0, 0.0, to.z > 0 ? 1.0 : -1.0};
  }

  const Upper& upper_;
  const Last& last_;
};

Mesh make_bow(const Cord& cord, Mesh& tips) {
  Mesh bow;
  for (int side = 0; side < kSides; ++side) {
    const double s = side == 0 ? -1.0 : 1.0;
    const double wide = side == 0 ? 0.94 : 1.0;
    const auto at = [&](double out, double down, double height) {
      return cord.beside_knot(s * wide * out, down, height);
    };
    const Vec3 knot = cord.knot_middle();
    const Polyline loop = {knot,
                           at(7, -1, 3.2),
                           at(15, -3, 4.0),
                           at(25, -4, 2.8),
                           at(34, -1, 1.2),
                           at(40, 5.5, 0.3),
                           at(38.5, 13, 0.1),
                           at(31, 15.5, 0.4),
                           at(21, 12, 2.0),
                           at(12, 6.5, 3.2),
                           at(6, 2.5, 3.4),
                           knot + Vec3(0.4, 0.0, 0.3 * s)};
    bow.append(cord.tube(loop, false, false));
    const Polyline tail = {knot,
                           at(4.5, 4, 3.2),
                           at(10, 12, 2.4),
                           at(16, 20, 0.4),
                           at(24, 28, 0.1),
                           at(34, 34, 0.1),
                           at(45, 37 + 3 * s, 0.1)};
    bow.append(cord.tube(tail, false, true));
    const Curve path = spline(tail);
    tips.append(cord.tube(path.part(1.0 - 11.0 / path.length(), 1.0).evenly(8), true, true, 1.08));
  }
  // The knot: the cord wrapped once around what runs through it.
  const Vec3 middle = cord.knot_middle();
  const Vec3 out = glm::normalize(cord.beside_knot(0.1, 0.0, 5.0) - cord.beside_knot(0.1, 0.0, 0.0));
  const Vec3 down = glm::normalize(cord.beside_knot(0.1, 3.0, 0.0) - cord.beside_knot(0.1, -3.0, 0.0));
  Polyline wrap;
  for (int i = 0; i <= 24; ++i) {
    const double turn = 2.3 * std::numbers::pi * i / 24.0;
    wrap.push_back(middle + 3.0 * std::cos(turn) * out + 3.3 * std::sin(turn) * down +
                   Vec3(0.0, 0.0, 2.6 * (i / 24.0 - 0.5)));
  }
  bow.append(cord.tube(wrap, true, true, 1.1));
  return bow;
}

}  // namespace

Laces make_laces(const Upper& upper, const Last& last) {
  const Cord cord(upper, last);
  Laces laces;
  for (int side = 0; side < kSides; ++side) laces.cord.append(cord.tube(cord.crossing(side), false, true));
  laces.cord.append(make_bow(cord, laces.tips));
  return laces;
}

}  // namespace vamp::shoe
