#pragma once
// Weights that know of the residual: functions chosen to explain a texel alone spend themselves on what the residual's
// mean and terms can tell as well.
#include "engine/fit/residual.h"

namespace vamp::fit {

// Solves the weights of each texel's functions again, together with the coefficients of the residual's terms: the least
// of |texel - functions - mean - terms|^2 + pull * |change of the functions' sum|^2, weights not negative. Without the
// pull, functions and terms that look alike would drift apart in opposite directions. `codes` are those that `weights`
// were made from; `residual` as from find_tables. One pass over the measurement.
void refit_weights(const Measurement& measurement, const Design& design, const std::vector<TexelCode>& codes,
                   const Clustering& clustering, const ResidualFit& residual, double pull, const Worker& worker,
                   std::vector<TexelWeights>& weights);

}  // namespace vamp::fit
