#include <algorithm>

#include "engine/core/check.h"
#include "engine/core/half.h"
#include "tools/presets/fit.h"

namespace vamp::presets {
namespace {

// A half rounded to 7 of its 10 mantissa bits: weights good to 0.4 %, files a third smaller.
uint32_t weight_half(float value) {
  const uint32_t bits = half_from_float(std::clamp(value, 0.f, 1000.f));
  return (bits + 4u) & 0xfff8u;
}

uint32_t coefficient_half(float value) { return (uint32_t{half_from_float(value)} + 8u) & 0xfff0u; }

}  // namespace

Spmm bake(const Surface& surface, const ParametricFit& parametric, const ResidualFit& residual) {
  Spmm spmm;
  spmm.width = spmm.height = kSide;
  spmm.mm_per_texel = static_cast<float>(surface.mm / kSide);
  spmm.dictionary = surface.dictionary;
  spmm.clusters = surface.clusters;
  spmm.residual = residual.residual;
  // The surface's v grows with its second axis; a texture's rows run the other way (phi = 90 degrees points to falling v).
  for (size_t row = 0; row < kTexels; ++row) {
    const size_t t = (kSide - 1 - row / kSide) * kSide + row % kSide;
    const auto first = static_cast<uint32_t>(spmm.entries.size());
    const auto& weights = parametric.weights[t];
    for (uint32_t j = 0; j < static_cast<uint32_t>(weights.rows()); ++j) {
      const Eigen::RowVector3f w = weights.row(j);
      if (w.maxCoeff() < 1e-4f) continue;
      spmm.entries.push_back({j | weight_half(w[0]) << 16, weight_half(w[1]) | weight_half(w[2]) << 16});
    }
    const auto count = static_cast<uint32_t>(spmm.entries.size()) - first;
    const auto& c = residual.coefficients[t];
    spmm.texels.push_back({first, uint32_t{surface.cluster[t]} | count << 8,
                           coefficient_half(c[0]) | coefficient_half(c[1]) << 16,
                           coefficient_half(c[2]) | coefficient_half(c[3]) << 16});
  }
  const Status status = validate(spmm, surface.name);
  CHECK(status.has_value());
  return spmm;
}

}  // namespace vamp::presets
