#pragma once
// What one evaluation costs on one core of this machine, in nanoseconds: representations compared at equal time.
#include "engine/material/spmm.h"

namespace vamp::fit {

// A material with so many terms of its residual; -1: its functions alone. In double, as the kernels' oracle.
double nanoseconds_of_material(const Spmm& spmm, int terms);

// A sum of `rank` tables over pairs of these directions, halves, each times a number of the texel: a truncated SVD. In
// float, nine records of the pair's neighbours.
double nanoseconds_of_tables(const std::vector<vec3>& directions, size_t texels, size_t rank);

}  // namespace vamp::fit
