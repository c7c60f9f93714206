#pragma once
// Tubes: a closed section carried along a path.
#include "tools/shoe/mesh.h"

namespace vamp::shoe {

struct Sweep {
  Polyline path;
  std::vector<Vec3> up;                         // per path point; made perpendicular to the path
  std::vector<Vec2> section;                    // closed, counter-clockwise; x to the side (up x tangent), y up; mm
  std::vector<double> scale;                    // of the section per path point; empty: 1
  bool round_start = false, round_end = false;  // close the ends by domes
};

// UV: u along the path, v around the section, mm.
Mesh build(const Sweep& sweep);

// An ellipse as a section.
std::vector<Vec2> ellipse(double side, double up, int corners, Vec2 centre = Vec2(0.0));
// A rectangle with half-round short sides: width * height over all.
std::vector<Vec2> flat_oval(double width, double height, int corners_per_end);

}  // namespace vamp::shoe
