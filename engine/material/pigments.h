#pragma once
// One colour for another in a fitted material, texel by texel: what a dyer does. The edit layer's gains act on whole
// clusters, whose texels are not all of one mixture, and on channels, of which a white highlight and a brown body share
// all three; here each weight is seen as a mixture of colours, and only one of them is exchanged (docs/edits.md).
#include <vector>

#include "engine/material/spmm.h"

namespace vamp {

struct PigmentChange {
  vec3 from{1}, to{0};        // linear Rec.709; `from` is not black
  std::vector<vec3> staying;  // colours that stay as they are: of other yarns, of highlights (white)
};

// What becomes of each of some colours.
std::vector<dvec3> changed_colours(const std::vector<dvec3>& colours, const PigmentChange& change);

// How much of a material is of the colour that goes.
struct PigmentShares {
  double light = 0;   // of what the functions reflect (mean_reflectance, all channels together)
  double texels = 0;  // in which it is a hundredth of that or more
  double untold = 0;  // relative RMSE of the weights seen as mixtures of the named colours
};
PigmentShares pigment_shares(const Spmm& spmm, const PigmentChange& change);

// The material with `from` exchanged for `to`: weights and residual of each cluster by the linear map of colours that
// comes nearest to what became of its weights, and of the named colours.
Spmm with_pigment(const Spmm& spmm, const PigmentChange& change);

}  // namespace vamp
