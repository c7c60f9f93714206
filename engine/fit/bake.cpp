#include "engine/fit/bake.h"

#include <algorithm>
#include <numeric>

#include "engine/core/half.h"

namespace vamp::fit {
namespace {

// Halves end where a sample of the material would be blinding light.
uint32_t half_of(float value) { return half_from_float(std::clamp(value, -6e4f, 6e4f)); }

Residual bake_residual(const Measurement& measurement, const ResidualFit& fit, size_t clusters, size_t terms) {
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
        record.halves[i / 2] |= half_of(row[i % 3 * pairs + pair] * scale) << (i % 2 * 16);
      }
    }
  return out;
}

}  // namespace

float stored(float weight) { return float_from_half(static_cast<uint16_t>(half_of(weight))); }

Spmm bake(const Measurement& measurement, const std::vector<Basis>& dictionary,
          const std::vector<TexelWeights>& weights, const Clustering& clustering, const ResidualFit* residual,
          size_t terms) {
  const BtfInfo& info = measurement.btf().info();
  Spmm spmm;
  spmm.width = static_cast<int>(info.width), spmm.height = static_cast<int>(info.height);
  if (info.mm_per_texel > 0) spmm.mm_per_texel = info.mm_per_texel;
  spmm.dictionary = dictionary;
  spmm.clusters.resize(clustering.count);
  if (residual != nullptr) spmm.residual = bake_residual(measurement, *residual, clustering.count, terms);
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
      for (size_t k = 0; k < terms; ++k) c[k] = half_of(residual->coefficients[t][k]);
    spmm.texels.push_back({first, uint32_t{clustering.of[t]} | static_cast<uint32_t>(order.size()) << 8,
                           c[0] | c[1] << 16, c[2] | c[3] << 16});
  }
  return spmm;
}

}  // namespace vamp::fit
