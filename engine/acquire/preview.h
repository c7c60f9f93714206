#pragma once
// A look at a mesostructure before it is measured.
#include "engine/acquire/goniometer.h"
#include "engine/image/image.h"

namespace vamp {
class Progress;
}

namespace vamp::acquire {

// Two pictures side by side, `side` pixels square each, of one period, row 0 at v = 0: seen from above with a light at
// 30 degrees from the normal (left), and seen from the lower right at 45 degrees, drawn on the texels as a goniometer
// does, with a light at 65 degrees, 10 degrees of half angle off the mirror (right). Both lights stand at the upper
// left, and there is a little light from everywhere. Channels R, G, B: a white Lambert plane that faces the light would
// show 1.
Image preview(const Mesostructure& structure, int side, int samples, int threads, Progress& progress);

}  // namespace vamp::acquire
