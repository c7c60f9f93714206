#pragma once
// The paper's way to few functions: an l1 penalty on the weights. Both walk from no function to many and end at the
// same non-negative least squares; they shrink the weights on the way, so that every support found is solved again
// without the penalty before its error counts.
#include <vector>

#include "engine/fit/elimination.h"

namespace vamp::fit {

// Non-negative group lasso, min 1/2 |X a - y|^2 + lambda sum_j |a_j|_2 over the channels of a function, by coordinate
// descent along falling lambda (Yuan and Lin 2006). The best support of each size up to `most`.
SparsePath group_lasso_path(const double* gram, size_t p, const TexelTarget& target, size_t most);

// Weights [channel * p + basis] at one lambda, from the start in `a`, to a violation of 1e-6 of the largest
// correlation.
void group_lasso(const double* gram, size_t p, const double* correlations, double lambda, std::vector<double>& a);

// Stagewise lasso (Zhao and Yu 2007, BLasso) with non-negative steps on the function's group: as its step goes to 0 its
// path goes to that of the lasso.
SparsePath stagewise_lasso_path(const double* gram, size_t p, const TexelTarget& target, size_t most);

// One point of that path: weights and the lambda that they belong to.
struct LassoPoint {
  double lambda = 0;
  std::vector<double> a;
};
// The whole path with steps of `step` times the largest single-function weight, until lambda reaches `least` of its
// start.
std::vector<LassoPoint> stagewise_lasso(const double* gram, size_t p, const double* correlations, double step,
                                        double least);

}  // namespace vamp::fit
