#pragma once
// Measurements whose truth is known: sums of known functions, as a goniometer would see them.
#include <random>
#include <vector>

#include "engine/btf/btf.h"
#include "engine/fit/columns.h"

namespace vamp::test {

struct SyntheticTexel {
  std::vector<int> support;   // of the dictionary, ascending
  std::vector<vec3> weights;  // one each
};

struct Synthetic {
  std::vector<Basis> dictionary;
  std::vector<SyntheticTexel> texels;
};

// Lobes of all models with tilted frames, of shapes that 15 degree spacing can tell: no two with a correlation above
// `closest` over the UBO2003 pairs, weighted as fits weigh them.
std::vector<Basis> random_dictionary(std::mt19937& random, size_t count, double closest = 0.97);

// Texels with `functions` of the dictionary each, weights from 0.1 to 1 times a colour.
Synthetic random_synthetic(uint32_t seed, int texels, size_t dictionary, size_t functions);

// The measurement of those texels under the 81 x 81 directions, in half floats.
Btf measure(const Synthetic& synthetic, int width, int height);

}  // namespace vamp::test
