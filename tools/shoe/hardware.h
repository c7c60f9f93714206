#pragma once
// Small parts: eyelets and the pull tab.
#include "tools/shoe/upper.h"

namespace vamp::shoe {

constexpr int kEyelets = 5;  // a side

// Where an eyelet stands, on the last; `row` counts from the throat up.
Vec3 eyelet_place(const Upper& upper, const Last& last, int side, int row);

Mesh make_eyelets(const Upper& upper, const Last& last);
// A strap folded to a loop over the back of the collar.
Mesh make_pull_tab(const Upper& upper, const Last& last);

}  // namespace vamp::shoe
