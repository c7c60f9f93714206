#pragma once
// Thread: rows of single stitches along seams.
#include "tools/shoe/panel.h"

namespace vamp::shoe {

struct Stitch {
  double pitch = 3.0;   // mm from hole to hole
  double length = 2.5;  // mm of thread that shows
  double radius = 0.36;
};

// A row along a curve on the last, on the outer face of `panel`.
Mesh stitch_row(const Curve& seam, const Panel& panel, const Last& last, const Stitch& stitch);
// A row along a curve in space on a face that points up.
Mesh stitch_row(const Curve& seam, const Stitch& stitch);

}  // namespace vamp::shoe
