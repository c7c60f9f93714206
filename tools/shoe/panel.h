#pragma once
// A leather panel: a patch of the last between four curves, with thickness, a folded rim and seams pressed into it.
#include "tools/shoe/last.h"
#include "tools/shoe/mesh.h"

namespace vamp::shoe {

struct Panel {
  // The four edges on the last, meeting at the corners; left to right and bottom to top, such that their cross product
  // points out of the last.
  Curve bottom, top, left, right;
  double base = 0.0;                        // distance of the flesh side from the last, mm
  double thickness = 1.6;                   // mm
  std::function<double(const Vec3&)> lift;  // extra distance from the last at a point of it, mm; may be empty
  std::vector<Curve> seams;                 // on the last; the thread pulls the leather down along them
  double cell = 2.4;                        // size of quads away from edges, mm
  bool fine_bottom = false, fine_top = false, fine_left = false,
       fine_right = false;    // rows of 0.5 mm near visible edges
  bool whole_back = false;    // model the flesh side too (else only a flange of it behind the rim)
  Vec3 grain{1.0, 0.0, 0.0};  // which way u runs
};

Mesh build(const Panel& panel, const Last& last);
// The flesh side alone, seen from inside the shoe: a lining.
Mesh build_lining(const Panel& panel, const Last& last);

// The height of the panel's outer face over the last at a point of the last.
double face_height(const Panel& panel, const Vec3& on_last);

// The curve `inside` mm away from an edge of a panel, on the last; the panel lies to the left of the edge as seen from
// outside (negative: to the right).
Curve inset(const Last& last, const Curve& edge, double inside);

}  // namespace vamp::shoe
