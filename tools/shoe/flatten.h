#pragma once
// Patterns: a curved panel laid flat with as little stretch as possible.
#include "tools/shoe/mesh.h"

namespace vamp::shoe {

// Replaces the mesh's UVs by its as-rigid-as-possible flattening (Liu et al. 2008, "A Local/Global Approach to Mesh
// Parameterization", the ARAP energy), starting from the UVs it has; then turns the pattern so that u follows `grain`
// (a direction in space) on average, scales it so that its area is the surface's, and puts its middle at the origin.
void flatten(Mesh& mesh, const Vec3& grain);

}  // namespace vamp::shoe
