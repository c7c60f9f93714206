#pragma once
// A look at a mesostructure before it is measured.
#include "engine/acquire/goniometer.h"
#include "engine/image/image.h"

namespace vamp {

class Progress;

// Two pictures side by side, `side` pixels square each, of one period seen from above (left) and at 45 degrees (right,
// drawn on the texels as a goniometer does): lit from the upper left at 30 and at 60 degrees from the normal, with a
// little light from everywhere. Channels R, G, B: radiance that a white Lambert plane facing the light would show as 1.
Image preview(const Mesostructure& structure, int side, int samples, int threads, Progress& progress);

}  // namespace vamp
