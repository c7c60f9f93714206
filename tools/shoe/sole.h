#pragma once
// Everything below the feather line: welt, midsole, outsole, heel; and the insole above it.
#include "tools/shoe/last.h"
#include "tools/shoe/mesh.h"

namespace vamp::shoe {

struct Sole {
  Mesh welt, midsole, outsole, heel, top_piece, insole;
  Curve welt_seam;  // on the welt's upper face, closed
};

Sole make_sole(const Last& last);

}  // namespace vamp::shoe
