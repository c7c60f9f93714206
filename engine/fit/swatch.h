#pragma once
// A picture of a material by its oracle in double, for the preset that a fit saves: no device is needed.
#include "engine/image/image.h"
#include "engine/material/spmm.h"

namespace vamp::fit {

// A ball of 36 mm (so that pictures of different materials compare) on a grey ground, seen orthographically: a key
// light from the upper left, a soft fill, a rim from behind, even light from all sides. Linear Rec.709 with a shoulder,
// ready for a display. `side` in pixels; the same picture whatever `threads`.
Image material_swatch(const Spmm& spmm, int side, int threads);

}  // namespace vamp::fit
