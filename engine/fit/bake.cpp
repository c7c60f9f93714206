#include "engine/fit/bake.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/core/half.h"
#include "engine/material/reflectance.h"

namespace vamp::fit {
namespace {

// Halves end where a sample of the material would be blinding light.
uint32_t half_of(float value) { return half_from_float(std::clamp(value, -6e4f, 6e4f)); }

// Shares of the error that is left: a texel has some five weights, and functions leave more than the whole does.
constexpr double kWeightShare = 1.0 / 16, kResidualShare = 1.0 / 8;

float rounded(float value, Step step) { return step.size > 0 ? std::round(value / step.size) * step.size : value; }

// Coefficients multiply terms of the size of what they add.
Step coefficient_step(const ResidualFit& fit, size_t term, double error) {
  const float* row = fit.terms.row(term);
  double square = 0;
  for (size_t i = 0; i < fit.terms.length; ++i) square += double{row[i]} * double{row[i]};
  const double size = std::sqrt(square / static_cast<double>(fit.terms.length));
  return size > 0 ? Step::at_most(kResidualShare * error / size) : Step{};
}

Residual bake_residual(const Measurement& measurement, const ResidualFit& fit, size_t clusters, size_t terms,
                       double error) {
  const Step step = Step::at_most(kResidualShare * error);
  Residual out;
  out.directions = measurement.pairs().views;
  out.terms = static_cast<int>(terms);
  const size_t pairs = measurement.pair_count();
  out.records.resize(clusters * pairs);
  for (size_t c = 0; c < clusters; ++c)
    for (size_t pair = 0; pair < pairs; ++pair) {
      tables::ResidualRecord& record = out.records[c * pairs + pair];
      std::fill(std::begin(record.halves), std::end(record.halves), 0u);
      const float scale = 1 / measurement.roots()[pair];
      for (size_t i = 0; i < 3 * (terms + 1); ++i) {
        const float* row = i < 3 ? fit.means.row(c) : fit.terms.row(c * kMaxTerms + i / 3 - 1);
        record.halves[i / 2] |= half_of(rounded(row[i % 3 * pairs + pair] * scale, step)) << (i % 2 * 16);
      }
    }
  return out;
}

}  // namespace

Step Step::at_most(double limit) {
  return {limit > 0 ? static_cast<float>(std::exp2(std::floor(std::log2(limit)))) : 0.f};
}

float stored(float weight, Step step) { return float_from_half(static_cast<uint16_t>(half_of(rounded(weight, step)))); }

void round_weights(const std::vector<Step>& steps, std::vector<TexelWeights>& weights) {
  for (TexelWeights& texel : weights)
    for (size_t i = 0; i < texel.weights.size(); ++i)
      texel.weights[i] = stored(texel.weights[i], steps[texel.bases[i / kChannels]]);
}

std::vector<Step> weight_steps(const Design& design, double error) {
  std::vector<Step> steps;
  for (size_t j = 0; j < design.columns.count; ++j) {
    const double size =
        std::sqrt(design.gram[j * design.columns.count + j] / static_cast<double>(design.columns.length));
    steps.push_back(size > 0 ? Step::at_most(kWeightShare * error / size) : Step{});
  }
  return steps;
}

Spmm bake(const Measurement& measurement, const std::vector<Basis>& dictionary,
          const std::vector<TexelWeights>& weights, const Clustering& clustering, const ResidualFit* residual,
          size_t terms, double error) {
  const BtfInfo& info = measurement.btf().info();
  Spmm spmm;
  spmm.width = static_cast<int>(info.width), spmm.height = static_cast<int>(info.height);
  if (info.mm_per_texel > 0) spmm.mm_per_texel = info.mm_per_texel;
  spmm.dictionary = dictionary;
  spmm.clusters.resize(clustering.count);
  if (residual != nullptr) spmm.residual = bake_residual(measurement, *residual, clustering.count, terms, error);
  std::vector<Step> steps;
  if (residual != nullptr)
    for (size_t i = 0; i < residual->terms.count; ++i) steps.push_back(coefficient_step(*residual, i, error));
  std::vector<size_t> order;
  for (size_t t = 0; t < weights.size(); ++t) {
    const TexelWeights& texel = weights[t];
    order.resize(texel.bases.size());
    std::iota(order.begin(), order.end(), size_t{0});
    std::sort(order.begin(), order.end(), [&](size_t a, size_t b) { return texel.bases[a] < texel.bases[b]; });
    const auto first = static_cast<uint32_t>(spmm.entries.size());
    for (const size_t i : order) {
      const float* w = texel.weights.data() + i * kChannels;
      spmm.entries.push_back({texel.bases[i] | half_of(w[0]) << 16, half_of(w[1]) | half_of(w[2]) << 16});
    }
    std::array<uint32_t, kMaxTerms> c{};
    if (residual != nullptr)
      for (size_t k = 0; k < terms; ++k)
        c[k] = half_of(rounded(residual->coefficients[t][k], steps[clustering.of[t] * kMaxTerms + k]));
    spmm.texels.push_back({first, uint32_t{clustering.of[t]} | static_cast<uint32_t>(order.size()) << 8,
                           c[0] | c[1] << 16, c[2] | c[3] << 16});
  }
  return spmm;
}

std::vector<vec3> cluster_colours(const Spmm& spmm) {
  const FitSums sums = fit_sums(spmm);
  AlbedoCurves curves;
  std::vector<vec3> colours;
  for (size_t c = 0; c < spmm.clusters.size(); ++c)
    colours.emplace_back(cluster_reflectance(spmm, {}, sums, static_cast<int>(c), curves));
  return colours;
}

}  // namespace vamp::fit
