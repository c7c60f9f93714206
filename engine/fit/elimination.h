#pragma once
// Few functions a texel: all of them by non-negative least squares, then the cheapest to lose goes first, again and
// again. Finds the functions of a sum exactly where greedy selection does not (docs/fitting.md).
#include <cstdint>
#include <vector>

#include "engine/fit/nnls.h"

namespace vamp::fit {

inline constexpr size_t kChannels = 3;

// The functions of one texel in the order of their worth, and what each brings.
struct SparsePath {
  std::vector<uint16_t> order;  // the best m are the first m
  std::vector<float> errors;    // [m]: squared error with m of them, m = 0 .. order.size()
};

// Right-hand sides of one texel: X'y of its channels, one after another, and the sum of |y|^2.
struct TexelTarget {
  const double* correlations = nullptr;  // [channel * p + basis]
  double square = 0;
};

class Elimination {
 public:
  Elimination(const double* gram, size_t p);

  // The path down to one function, from at most `most` on (all that have a weight where `most` is 0).
  SparsePath path(const TexelTarget& target, size_t most);

  // Weights of these functions, [channel * p + basis]; the others 0. Returns the squared error.
  double weights(const TexelTarget& target, const std::vector<int>& support, std::vector<double>& a);

 private:
  const double* gram_;
  size_t p_;
  std::vector<Nnls> solvers_;  // one a channel
  std::vector<double> a_;
};

}  // namespace vamp::fit
