#pragma once
// The weights of every texel: few functions each, chosen by what they bring.
#include <cstdint>
#include <vector>

#include "engine/fit/elimination.h"
#include "engine/fit/measurement.h"
#include "engine/fit/parallel.h"
#include "engine/fit/rows.h"

namespace vamp::fit {

// One texel's functions in the order of their worth, with what is needed to solve for any number of them.
struct TexelCode {
  SparsePath path;
  std::vector<float> correlations;  // [channel * order.size() + place]: X'y of the functions of the path
};

// A dictionary over a measurement's pairs.
struct Design {
  Rows columns;              // one a basis, times the roots
  std::vector<double> gram;  // bases x bases
};
Design make_design(const std::vector<Basis>& dictionary, const Measurement& measurement);

enum class Coder { elimination, group_lasso, stagewise_lasso };

// Paths of all texels down from at most `most` functions. `allowed[group_of[t]]` are the bases that texel t may use;
// all of them where `allowed` is empty.
struct CodingGroups {
  std::vector<std::vector<int>> allowed;
  const std::vector<uint16_t>* group_of = nullptr;
};
std::vector<TexelCode> code_texels(const Measurement& measurement, const Design& design, const CodingGroups& groups,
                                   Coder coder, size_t most, const Worker& worker);

// How many functions each texel gets when one more has to lower its squared error by at least `price`.
std::vector<size_t> counts_at(const std::vector<TexelCode>& codes, double price);
// Squared error of all texels with these counts.
double error_of(const std::vector<TexelCode>& codes, const std::vector<size_t>& counts);
// The dearest price at which the squared error of all texels is at most `error`; 0 where it never is.
double price_for(const std::vector<TexelCode>& codes, double error);

// Non-negative weights of the first `count` functions of a code, [place][channel].
std::vector<float> weights_of(const TexelCode& code, size_t count, const std::vector<double>& gram, size_t bases);

}  // namespace vamp::fit
