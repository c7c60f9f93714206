#include "tools/shoe/upper.h"

#include <algorithm>

#include "tools/shoe/flatten.h"
#include "tools/shoe/sweep.h"

namespace vamp::shoe {
namespace {

// Layers from the last outwards, mm. Each lies a hair above the one below.
constexpr double kLeather = 1.6;
constexpr double kVampBase = 0.1;
constexpr double kSecondBase = kVampBase + kLeather + 0.1;   // toe cap, quarters
constexpr double kThirdBase = kSecondBase + kLeather + 0.1;  // heel counter
constexpr double kTongueThickness = 2.4;
constexpr double kFacingLift = 1.2;  // laces pass under the facings
constexpr double kFacingLiftReach = 24.0;
constexpr double kTuck = -3.0;  // panels run on below the feather line into the welt
constexpr double kHalfBackSeam = 0.85;

struct Pattern {
  const Last& last;
  Curve edge;  // outline at kTuck: heel, medial, toe, lateral, heel

  double share(double x, double side) const { return edge.share_of_nearest(last.wall(x, kTuck, side)); }
  // A curve through points whose ends are moved exactly onto given ones.
  Curve between(const Vec3& from, Polyline inner, const Vec3& to) const {
    inner.insert(inner.begin(), from);
    inner.push_back(to);
    return last.through(inner);
  }
};

Curve across(const Pattern& p, double x_edge, double x_wall, double above_wall, double x_roof, double from_ridge,
             double x_ridge) {
  const Last& l = p.last;
  return p.between(p.edge(p.share(x_edge, -1)),
                   {l.wall(x_wall, above_wall, -1), l.roof(x_roof, -from_ridge), l.roof(x_ridge, 0),
                    l.roof(x_roof, from_ridge), l.wall(x_wall, above_wall, 1)},
                   p.edge(p.share(x_edge, 1)));
}

Panel cut_toe_cap(const Pattern& p) {
  Panel cap;
  cap.bottom = across(p, 221, 224, 17, 230, 17, 232);
  const double medial = p.edge.share_of_nearest(cap.bottom(0)), lateral = p.edge.share_of_nearest(cap.bottom(1));
  const double a = glm::mix(medial, lateral, 0.34), b = glm::mix(medial, lateral, 0.66);
  cap.left = p.edge.part(medial, a);
  cap.top = p.edge.part(a, b);
  cap.right = p.edge.part(b, lateral).reversed();
  cap.base = kSecondBase;
  cap.fine_bottom = true;
  cap.seams = {inset(p.last, cap.bottom, 2.2), inset(p.last, cap.bottom, 4.4)};
  return cap;
}

Panel cut_vamp(const Pattern& p) {
  Panel vamp;
  vamp.bottom = across(p, 116, 128, 24, 166, 15, 174);
  vamp.top = across(p, 230, 233, 17, 239, 17, 241);
  const auto at = [&](const Vec3& point) { return p.edge.share_of_nearest(point); };
  vamp.left = p.edge.part(at(vamp.bottom(0)), at(vamp.top(0)));
  vamp.right = p.edge.part(at(vamp.top(1)), at(vamp.bottom(1))).reversed();
  vamp.base = kVampBase;
  vamp.fine_bottom = true;
  return vamp;
}

Panel cut_counter(const Pattern& p) {
  const Last& l = p.last;
  Panel counter;
  const double medial = p.share(80, -1), lateral = p.share(84, 1);
  counter.bottom = join(p.edge.part(lateral, 1.0), p.edge.part(0.0, medial)).reversed();
  counter.top =
      l.through({l.wall(62, 29, -1), l.wall(47, 36.5, -1), l.wall(30, 43, -1), l.heel(-13, 46.5), l.heel(0, 47.5),
                 l.heel(13, 46.5), l.wall(30, 43, 1), l.wall(47, 36.5, 1), l.wall(62, 29, 1)});
  counter.left = p.between(counter.bottom(0), {l.wall(77.5, 8, -1), l.wall(71.5, 19, -1)}, counter.top(0));
  counter.right = p.between(counter.bottom(1), {l.wall(80, 8, 1), l.wall(72.5, 19, 1)}, counter.top(1));
  counter.base = kThirdBase;
  counter.fine_left = counter.fine_right = counter.fine_top = true;
  const Curve rim = join(join(counter.right, counter.top.reversed()), counter.left.reversed());
  counter.seams = {inset(l, rim, 2.2), inset(l, rim, 4.4)};
  counter.grain = {0.0, 0.0, 1.0};
  return counter;
}

// The front edge of a quarter from the feather over the throat to the top of the facing.
Curve front_edge(const Pattern& p, double side, const Vec3& from) {
  const Last& l = p.last;
  return p.between(
      from,
      {l.wall(side > 0 ? 146.5 : 144.5, 9, side), l.wall(156, 23, side), l.wall(168.5, 35, side),
       l.roof(179.5, 21 * side), l.roof(184.5, 13.5 * side), l.roof(182.5, 9.2 * side), l.roof(176, 8.2 * side),
       l.roof(160, 8.8 * side), l.roof(144, 9.8 * side), l.roof(128, 11.2 * side)},
      l.roof(117, 12.5 * side));
}

Curve half_topline(const Pattern& p, double side, double half_back_seam, const Vec3& facing_top) {
  const Last& l = p.last;
  return p.between(l.heel(half_back_seam * side, 58),
                   {l.heel(14 * side, 57), l.wall(28, 54, side), l.wall(48, 49, side), l.wall(68, 47.5, side),
                    l.wall(86, 54, side), l.wall(101, 68, side)},
                   facing_top);
}

Panel cut_quarter(const Pattern& p, int side_index, double half_back_seam, Curve& facing) {
  const Last& l = p.last;
  const double side = side_index == 0 ? -1.0 : 1.0;
  const double from = p.share(142, side);
  const Curve front = front_edge(p, side, p.edge(from));
  const Curve top = half_topline(p, side, half_back_seam, front(1));
  Polyline back_points;
  for (double above : {kTuck, 5.0, 15.0, 30.0, 45.0}) back_points.push_back(l.heel(half_back_seam * side, above));
  back_points.push_back(top(0));
  const Curve back = l.through(back_points);
  facing = front.part(front.share_of_nearest(l.roof(183, 10.0 * side)), 1.0);

  Panel quarter;
  if (side > 0) {
    const double to = p.edge.share_of_nearest(back(0));  // the outline begins and ends in the back seam
    quarter.bottom = p.edge.part(from, to > 0.5 ? to : 1.0).reversed();
    quarter.left = back;
    quarter.right = front;
    quarter.top = top;
    quarter.fine_right = quarter.fine_top = true;
  } else {
    const double to = p.edge.share_of_nearest(back(0));
    quarter.bottom = p.edge.part(to < 0.5 ? to : 0.0, from).reversed();
    quarter.left = front;
    quarter.right = back;
    quarter.top = top.reversed();
    quarter.fine_left = quarter.fine_top = true;
  }
  quarter.base = kSecondBase;
  const Curve line = facing;
  quarter.lift = [line](const Vec3& on_last) {
    return kFacingLift * (1.0 - smooth_step(4.0, kFacingLiftReach, line.distance(on_last)));
  };
  // Rows end short of the corner, where they would cross.
  const auto short_of_end = [](const Curve& c, double mm) { return c.part(0.0, 1.0 - mm / c.length()); };
  quarter.seams = {short_of_end(inset(l, front, 2.2 * side), 2.6), short_of_end(inset(l, front, 4.4 * side), 3.2),
                   short_of_end(inset(l, top, -2.6 * side), 7.4)};
  return quarter;
}

Panel cut_tongue(const Last& l) {
  Panel tongue;
  tongue.bottom = l.through({l.roof(111, -25), l.roof(105.5, -20.5), l.roof(102.5, -12), l.roof(102.3, 0),
                             l.roof(102.5, 12), l.roof(105.5, 20.5), l.roof(111, 25)});
  tongue.top = l.through({l.roof(190, -17), l.roof(192, 0), l.roof(190, 17)});
  tongue.left = l.through({tongue.bottom(0), l.roof(135, -24), l.roof(165, -20), tongue.top(0)});
  tongue.right = l.through({tongue.bottom(1), l.roof(135, 24), l.roof(165, 20), tongue.top(1)});
  tongue.base = -kTongueThickness;
  tongue.thickness = kTongueThickness;
  tongue.fine_bottom = tongue.fine_left = tongue.fine_right = true;
  tongue.whole_back = true;
  tongue.seams = {inset(l, tongue.bottom, 3.0)};
  return tongue;
}

}  // namespace

Upper cut_upper(const Last& last) {
  const Pattern pattern{last, last.outline(kTuck)};
  Upper upper;
  upper.toe_cap = cut_toe_cap(pattern);
  upper.vamp = cut_vamp(pattern);
  upper.counter = cut_counter(pattern);
  upper.tongue = cut_tongue(last);
  for (int side = 0; side < kSides; ++side) {
    const auto s = static_cast<size_t>(side);
    upper.quarter[s] = cut_quarter(pattern, side, kHalfBackSeam, upper.facing[s]);
    upper.quarter_lining[s] = cut_quarter(pattern, side, 0.0, upper.facing[s]);
    upper.quarter_lining[s].base -= 0.15;
  }
  upper.topline = join(upper.quarter[0].top, upper.quarter[1].top);
  return upper;
}

Mesh make_collar(const Upper& upper, const Last& last) {
  constexpr int kRows = 220;
  constexpr double kTaper = 16.0;  // mm over which the padding runs out towards the facings
  Sweep roll;
  roll.path = upper.topline.evenly(kRows);
  const double length = upper.topline.length();
  for (int i = 0; i < kRows; ++i) {
    const auto s = static_cast<size_t>(i);
    const double along = length * i / (kRows - 1);
    const double near_end = std::min(along, length - along);
    const double padding = smooth_step(0.0, kTaper, near_end);
    roll.scale.push_back(0.2 + 0.8 * padding);
    // Towards its ends the roll slips under the facings.
    const Vec3 n = last.normal(roll.path[s]);
    roll.up.push_back(n);
    roll.path[s] += glm::mix(-0.3, 0.6, padding) * n;
  }
  roll.section = ellipse(5.6, 3.5, 26, {0.6, -1.2});
  roll.round_start = roll.round_end = true;
  return build(roll);
}

Mesh make_lining(const Upper& upper, const Last& last) {
  Panel front = upper.vamp;
  front.base -= 0.5;
  Mesh all = build_lining(front, last);
  for (const Panel& quarter : upper.quarter_lining) all.append(build_lining(quarter, last));
  return all;
}

}  // namespace vamp::shoe
