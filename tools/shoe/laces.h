#pragma once
// The laces: two ends crossing up through the eyelets, tied in a bow.
#include "tools/shoe/upper.h"

namespace vamp::shoe {

struct Laces {
  Mesh cord, tips;  // the tips are the stiff ends
};

Laces make_laces(const Upper& upper, const Last& last);

}  // namespace vamp::shoe
