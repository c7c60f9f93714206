#pragma once
// The last: the form of a right foot on which the upper is built. x runs from heel (0) to toe (300), y up from the
// ground, z to the outer (lateral) side; mm.
#include "tools/shoe/curve.h"

namespace vamp::shoe {

class Last {
 public:
  Last();

  // < 0 inside, 0 on the last, > 0 outside; smooth (C2), but no distance.
  double field(const Vec3& p) const;
  Vec3 normal(const Vec3& p) const;                 // unit, outward, of the level surface through p
  Vec3 project(Vec3 p) const;                       // the point of the last reached from p along the field's gradient
  Vec3 lifted(const Vec3& p, double offset) const;  // project(p), moved outward by `offset`
  double height(const Vec3& p) const;               // signed distance from the last to first order

  // Points by the charts that pattern makers use. `above` is the height over the feather line (the edge of the bottom).
  Vec3 wall(double x, double above, double side) const;  // side +1 lateral, -1 medial
  Vec3 heel(double z, double above) const;               // on the back of the heel
  Vec3 roof(double x, double from_ridge) const;          // on top, `from_ridge` along z from the ridge, + lateral

  double feather(double x) const { return feather_(x); }  // height of the bottom's edge over the ground
  // The outline at a height over the feather, closed, from the middle of the heel over the medial side, the toe and the
  // lateral side back to the heel.
  Curve outline(double above) const;
  Curve through(const Polyline& points) const;  // the spline through points, laid onto the last

 private:
  double centre(double x, double above) const;
  double width(double x, double above) const;
  double ends(double x, double above) const;

  Profile feather_, lateral_, medial_, ridge_height_, ridge_shift_, back_;
};

}  // namespace vamp::shoe
