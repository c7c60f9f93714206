#pragma once
// What the functions leave: per cluster a mean and up to four PCA terms over the measured pairs, per texel the terms'
// coefficients (Silva and Santos 2013, eq. 3).
#include <array>
#include <vector>

#include "engine/fit/clusters.h"
#include "engine/fit/coding.h"
#include "engine/fit/coordinates.h"

namespace vamp::fit {

inline constexpr size_t kMaxTerms = kMaxResidualTerms;

// Weights of one texel, as they are stored.
struct TexelWeights {
  std::vector<uint16_t> bases;
  std::vector<float> weights;  // [place][channel]
};

// The coordinates of what the functions leave of each texel.
Rows residual_coordinates(const Coordinates& found, const Design& design, const std::vector<TexelWeights>& weights);

// One row of what the functions leave of a texel: Measurement::values() floats, each times its root.
void read_residual(const Measurement& measurement, const Design& design, const TexelWeights& weights, size_t texel,
                   float* out);

struct ResidualFit {
  Rows means;                                              // clusters x values, times the roots
  Rows terms;                                              // clusters * kMaxTerms x values; times the roots
  std::vector<std::array<float, kMaxTerms>> coefficients;  // a texel
  // Squared errors of all texels: functions alone, with the mean, with 1 .. kMaxTerms terms.
  std::array<double, kMaxTerms + 2> errors{};
};

// A pass over the measurement: means, and terms from the coordinates' principal axes, orthonormal in each cluster.
ResidualFit find_tables(const Measurement& measurement, const Design& design, const std::vector<TexelWeights>& weights,
                        const Rows& coordinates, const Clustering& clustering, size_t terms, const Worker& worker);

// Another: the best coefficients and what is left then. Afterwards the coefficients' root mean square over each cluster
// is 1, and terms are of the size of what they add.
void fit_coefficients(const Measurement& measurement, const Design& design, const std::vector<TexelWeights>& weights,
                      const Clustering& clustering, const Worker& worker, ResidualFit& fit);

}  // namespace vamp::fit
