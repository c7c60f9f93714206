#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "engine/core/half.h"
#include "engine/material/directions.h"
#include "tools/presets/fit.h"

namespace vamp::presets {
namespace {

constexpr int kTerms = 4, kValues = 3 * kPairs;
constexpr int kSamples = 96;  // texels of a cluster that its PCA is made from

// A residual as one row: [pair][channel].
using Row = Eigen::RowVectorXf;

Row leftover(const Goniometer& goniometer, const ParametricFit& fit, int texel, const Eigen::Matrix3Xf& mean) {
  Eigen::Matrix3Xf data = body_leftover(goniometer, fit, texel) - mean;
  return Eigen::Map<Row>(data.data(), kValues);
}

// The bits of a half with its mantissa rounded to 5 of 10 bits: the residual is good to 1.6 percent, and rounded
// tables deflate to half their size.
uint32_t rounded_half(float value) {
  const uint32_t bits = half_from_float(std::clamp(value, -1000.f, 1000.f));
  if ((bits & 0x7fffu) < 0x0a00u) return 0;  // below 2e-4: nothing that is seen
  return (bits + 16u) & 0xffe0u;
}

}  // namespace

ResidualFit fit_residual(const Surface& surface, const Goniometer& goniometer, const ParametricFit& fit) {
  const size_t clusters = surface.clusters.size();
  const Eigen::RowVectorXf w = pair_weights();
  Row weights(kValues);
  for (int i = 0; i < kValues; ++i) weights[i] = w[i / 3];

  ResidualFit out;
  out.residual.directions = ubo2003_directions();
  out.residual.terms = kTerms;
  out.residual.records.resize(clusters * kPairs);
  out.coefficients.assign(kTexels, Eigen::Vector4f::Zero());
  parallel(static_cast<int>(clusters), [&](int c) {
    std::vector<int> members;
    for (int t = 0; t < kTexels; ++t)
      if (surface.cluster[static_cast<size_t>(t)] == c) members.push_back(t);
    const Eigen::Matrix3Xf& mean = fit.mean[static_cast<size_t>(c)];
    // PCA by the small Gram matrix of the sampled texels.
    const int samples = std::min(kSamples, static_cast<int>(members.size()));
    Eigen::MatrixXf rows(samples, kValues);
    for (int i = 0; i < samples; ++i)
      rows.row(i) = leftover(goniometer, fit,
                             members[members.size() * static_cast<size_t>(i) / static_cast<size_t>(samples)], mean)
                        .cwiseProduct(weights);
    Eigen::MatrixXf terms = Eigen::MatrixXf::Zero(kTerms, kValues), projections = terms;
    if (samples > 0) {
      const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> solver((rows * rows.transpose()).cast<double>());
      for (int k = 0; k < std::min(kTerms, samples); ++k) {
        const double lambda = solver.eigenvalues()[samples - 1 - k];
        if (lambda < 1e-6 * std::max(solver.eigenvalues()[samples - 1], 1e-9)) continue;  // fewer kinds than terms
        const Row direction = solver.eigenvectors().col(samples - 1 - k).transpose().cast<float>() * rows /
                              static_cast<float>(std::sqrt(lambda));
        // Scaled so that coefficients are about 1 and a term has the size of what it adds.
        const auto scale = static_cast<float>(std::sqrt(lambda / samples));
        terms.row(k) = direction.cwiseQuotient(weights) * scale;
        projections.row(k) = direction.cwiseProduct(weights) / scale;
      }
    }
    for (const int t : members)
      out.coefficients[static_cast<size_t>(t)] =
          (projections * leftover(goniometer, fit, t, mean).transpose()).cwiseMin(4.f).cwiseMax(-4.f);
    for (int pair = 0; pair < kPairs; ++pair) {
      auto& record = out.residual.records[static_cast<size_t>(c) * kPairs + static_cast<size_t>(pair)];
      std::fill(std::begin(record.halves), std::end(record.halves), 0u);
      for (int i = 0; i < 3 * (kTerms + 1); ++i) {
        const float value = i < 3 ? mean(i, pair) : terms(i / 3 - 1, 3 * pair + i % 3);
        record.halves[i / 2] |= rounded_half(value) << (i % 2 * 16);
      }
    }
  });
  return out;
}

}  // namespace vamp::presets
