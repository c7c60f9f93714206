#pragma once
// One dictionary for the whole material: few functions that all of its texels share.
#include <vector>

#include "engine/fit/clusters.h"
#include "engine/fit/lobe_fit.h"

namespace vamp::fit {

struct DictionaryOptions {
  size_t bases = 32;     // at most
  size_t functions = 5;  // of them a texel may use while the dictionary is chosen and refined
  int rounds = 12;       // of coding and refinement; 0 leaves the lobes as they were found
  double guard = 1.5;    // see explodes()
};

// The texels that a dictionary is made for: rows as Measurement::read gives them, each times the root of how many
// texels it stands for.
struct Exemplars {
  const Pairs* pairs = nullptr;
  const std::vector<float>* roots = nullptr;
  LobeLimits limits;
  Rows rows;  // one a texel, 3 * pairs long
};

// Whether a function is far brighter between the measured directions than on them, where nothing held it: its mean
// square over dense directions up to 85 degrees, against that over the measured ones, both weighted with the cosines.
bool explodes(const Basis& basis, const Pairs& pairs, double guard);

// Without those that explode or, to a correlation of 0.9995, repeat another.
std::vector<Basis> without_repeats(const std::vector<Basis>& bases, const Exemplars& exemplars, double guard,
                                   const Worker& worker);

// The `options.bases` that together serve the exemplars best: greedy, all exemplars at once, then rounds of sparse
// coding and joint refinement.
std::vector<Basis> choose_dictionary(const std::vector<Basis>& candidates, const Exemplars& exemplars,
                                     const DictionaryOptions& options, const Worker& worker);

}  // namespace vamp::fit
