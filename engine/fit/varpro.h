#pragma once
// Levenberg and Marquardt over the parameters of lobes, with the weights eliminated by non-negative least squares
// (variable projection: Golub and Pereyra 1973, in Kaufman's form of 1975), in Gram space: a step works on products of
// columns, never on the columns themselves.
#include <memory>
#include <vector>

#include "engine/fit/columns.h"
#include "engine/fit/parameters.h"

namespace vamp::fit {

// Texels that share lobes. Rows of one texel follow one another: `channels` rows of pairs.count() floats, each times
// the root of its pair's weight.
struct LobeTargets {
  const Pairs* pairs = nullptr;
  const float* roots = nullptr;  // one a pair
  std::vector<const float*> texels;
  size_t channels = 3;
};

class VariableProjection {
 public:
  VariableProjection(const LobeTargets& targets, const LobeLimits& limits);
  ~VariableProjection();

  // Which bases each texel may use from now on; all of them to begin with.
  void restrict_to(std::vector<std::vector<int>> supports);

  // Squared error of these bases at the best weights.
  double evaluate(const std::vector<Basis>& bases);

  // Improves bases[first ..]; those before stay. At most `iterations` steps, fewer when a step gains less than 1e-4 of
  // the error twice in a row. Returns the squared error.
  double improve(std::vector<Basis>& bases, size_t first, int iterations);

  // Of the last state: weights [(texel * channels + channel) * bases + basis].
  const std::vector<double>& weights() const;
  // Sum of squares of all rows.
  double square() const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace vamp::fit
