#include "engine/material/residual_follow.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "engine/core/half.h"
#include "engine/material/frame.h"
#include "engine/material/reflectance.h"

namespace vamp {
namespace {

// Pairs to look at: spread over all, fewer where a large dictionary would make them dear.
std::vector<size_t> some_pairs(size_t directions, size_t bases) {
  const size_t all = directions * directions;
  const size_t wanted = std::clamp<size_t>((size_t{1} << 20) / std::max<size_t>(bases, 1), 64, 1024);
  std::vector<size_t> pairs;
  // All views, and of each other lights.
  const double step = static_cast<double>(all) / static_cast<double>(std::min(wanted, all));
  for (size_t i = 0; i < std::min(wanted, all); ++i)
    pairs.push_back(static_cast<size_t>(step * static_cast<double>(i)));
  return pairs;
}

// The energy of a cluster's residual at a pair: coefficients have mean square 1 over the cluster.
dvec3 energy_of(const Residual& residual, size_t record) {
  const auto value = [&](int i) {
    return double{
        float_from_half(static_cast<uint16_t>(residual.records[record].halves[i / 2] >> (i % 2 * 16) & 0xffffu))};
  };
  dvec3 energy(0);
  for (int i = 0; i < 3 * (residual.terms + 1); ++i) energy[i % 3] += value(i) * value(i);
  return energy;
}

// [pair][basis]: what each function reflects.
std::vector<double> values_at(const Spmm& spmm, const std::vector<size_t>& pairs) {
  const size_t bases = spmm.dictionary.size(), count = spmm.residual.directions.size();
  std::vector<double> values(pairs.size() * bases);
  for (size_t j = 0; j < bases; ++j) {
    const Basis& basis = spmm.dictionary[j];
    const BasisFrame frame(dvec3(basis.normal), double{basis.psi});
    const PackedLobe lobe = pack_lobe(basis.lobe);
    for (size_t p = 0; p < pairs.size(); ++p) {
      const dvec3 wo(spmm.residual.directions[pairs[p] / count]), wi(spmm.residual.directions[pairs[p] % count]);
      values[p * bases + j] = std::max(lobe_value(lobe, frame.local(wi), frame.local(wo)), 0.0);
    }
  }
  return values;
}

// 1 for grey, little for a colour: a third power keeps all but highlights out.
double whiteness_of(const dvec3& weight) {
  const double high = std::max({weight.x, weight.y, weight.z}), low = std::min({weight.x, weight.y, weight.z});
  return high > 0 ? std::pow(std::max(low, 0.0) / high, 3) : 0;
}

// Of a frame, at most that of 70 degrees.
double slope_of(vec3 normal) {
  const double x{normal.x}, y{normal.y};
  return std::min(std::sqrt(x * x + y * y) / std::max(double{normal.z}, 1e-3), 2.75);
}

// Below this slope (5 degrees) there is nothing to scale.
constexpr double kFlat = 0.0875;

// How far the residual's colour goes with its functions' colours (docs/edits.md).
constexpr double kColour = 1.0 / 3;

}  // namespace

ResidualShares residual_shares(const Spmm& spmm, const std::vector<dvec3>& weights) {
  const size_t bases = spmm.dictionary.size(), count = spmm.residual.directions.size();
  ResidualShares shares{std::vector<dvec3>(spmm.clusters.size() * bases, dvec3(0)),
                        std::vector<dvec3>(spmm.clusters.size(), dvec3(0))};
  if (spmm.residual.records.empty()) return shares;
  const std::vector<size_t> pairs = some_pairs(count, bases);
  const std::vector<double> values = values_at(spmm, pairs);
  for (size_t c = 0; c < spmm.clusters.size(); ++c) {
    const dvec3* weight = weights.data() + c * bases;
    dvec3* share = shares.of_basis.data() + c * bases;
    std::vector<double> whiteness;
    for (size_t j = 0; j < bases; ++j) whiteness.push_back(whiteness_of(weight[j]));
    dvec3 told(0);
    for (size_t p = 0; p < pairs.size(); ++p) {
      const dvec3 energy = energy_of(spmm.residual, c * count * count + pairs[p]);
      const double* value = values.data() + p * bases;
      dvec3 light(0), white(0);
      for (size_t j = 0; j < bases; ++j) {
        light += weight[j] * value[j];
        white += weight[j] * value[j] * whiteness[j];
      }
      // Energy that all channels have in proportion to their light.
      double common = std::numeric_limits<double>::infinity();
      for (int i = 0; i < 3; ++i)
        if (light[i] > 0) common = std::min(common, std::sqrt(energy[i]) / light[i]);
      for (int i = 0; i < 3; ++i) {
        if (!(light[i] > 0 && energy[i] > 0)) continue;
        const double part = white[i] > 0 ? std::min(common * light[i] / std::sqrt(energy[i]), 1.0) : 1.0;
        const double by_light = energy[i] * part / light[i];
        const double by_white = white[i] > 0 ? energy[i] * (1 - part) / white[i] : 0.0;
        for (size_t j = 0; j < bases; ++j)
          share[j][i] += weight[j][i] * value[j] * (by_light + by_white * whiteness[j]);
        told[i] += energy[i];
      }
    }
    const double all = told.x + told.y + told.z;
    for (int i = 0; i < 3; ++i) {
      for (size_t j = 0; told[i] > 0 && j < bases; ++j) share[j][i] /= told[i];
      if (all > 0) shares.of_channel[c][i] = told[i] / all;
    }
  }
  return shares;
}

double lobe_size(const Lobe& lobe) {
  constexpr int kSide = 24;
  const dvec3 wo(0.5 * std::cos(0.4), 0.5 * std::sin(0.4), std::sqrt(0.75));
  double sum = 0;
  for (int y = 0; y < kSide; ++y)
    for (int x = 0; x < kSide; ++x) {
      const LobeSample sample = sample_lobe(lobe, wo, (x + 0.5) / kSide, (y + 0.5) / kSide);
      if (sample.valid) sum += sample.weight * sample.weight * sample.pdf;
    }
  return std::sqrt(sum / (kSide * kSide));
}

double LobeSizes::of(const Lobe& lobe) {
  for (const auto& [known, size] : known_)
    if (known == lobe) return size;
  return known_.emplace_back(lobe, lobe_size(lobe)).second;
}

dvec3 residual_scale(const Spmm& spmm, const EditLayer& edits, const FitSums& sums, int cluster, LobeSizes& sizes) {
  const bool follow = edits.residual_policy == ResidualPolicy::follow, solo = any_solo(edits, cluster);
  const size_t bases = spmm.dictionary.size();
  dvec3 scale(0), known(0);
  double light = 0, fitted_slope = 0, edited_slope = 0;
  for (size_t j = 0; j < bases; ++j) {
    const BasisKey key{cluster, static_cast<int>(j)};
    const BasisEdit edit = edits.edit_of(key);
    const Basis& fitted = spmm.dictionary[j];
    const size_t at = static_cast<size_t>(cluster) * bases + j;
    double size = 1;
    if (!follow && (edit.lobe || edit.normal || edit.psi)) size = 0;
    // At most 4: from almost nothing to something there is no ratio.
    if (follow && edit.lobe) size = std::min(sizes.of(*edit.lobe) / std::max(sums.sizes[j], 1e-6), 4.0);
    scale += sums.residual.of_basis[at] * dvec3(effective_gain(edit, solo)) * size;
    known += sums.residual.of_basis[at];
    const dvec3& weight = sums.weights[at];
    const double here = (weight.x + weight.y + weight.z) * sums.mean_reflectance[j];
    light += here;
    fitted_slope += here * slope_of(fitted.normal);
    edited_slope += here * slope_of(edit.normal.value_or(fitted.normal));
  }
  const double relief = follow && light > 0 ? (edited_slope + kFlat * light) / (fitted_slope + kFlat * light) : 1.0;
  const double grey = dot(scale, sums.residual.of_channel[static_cast<size_t>(cluster)]);
  for (int i = 0; i < 3; ++i) scale[i] = known[i] > 0.5 ? relief * (grey + kColour * (scale[i] - grey)) : 1;
  return scale;
}

}  // namespace vamp
