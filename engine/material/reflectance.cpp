#include "engine/material/reflectance.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "engine/core/half.h"

namespace vamp {
namespace {

// Half-vector lobes fade to nothing where the viewer sinks below their own horizon; Lambert and Oren-Nayar do not.
bool cut_at_view_horizon(const Lobe& lobe) { return lobe.model != Model::lambert && lobe.model != Model::oren_nayar; }

}  // namespace

double normal_albedo(const Basis& basis) {
  return double{lobe_albedo(basis.lobe, std::clamp(basis.normal.z, 0.f, 1.f))};
}

AlbedoCurve albedo_curve(const Lobe& lobe) {
  AlbedoCurve curve;
  for (size_t i = 0; i < curve.size(); ++i) {
    const float t = std::max(static_cast<float>(i) / static_cast<float>(curve.size() - 1), 0.02f);
    curve[i] = double{lobe_albedo(lobe, t * t)};
  }
  return curve;
}

const AlbedoCurve& AlbedoCurves::of(const Lobe& lobe) {
  for (const auto& [known, curve] : known_)
    if (known == lobe) return curve;
  return known_.emplace_back(lobe, albedo_curve(lobe)).second;
}

double mean_reflectance(const Basis& basis, const AlbedoCurve& curve) {
  if (basis.lobe.model == Model::lambert) return curve.back();
  constexpr int kNodes = std::tuple_size_v<AlbedoCurve> - 1;
  // Viewers: equal areas of the projected hemisphere, 16 rings of 16 azimuths.
  constexpr int kRings = 16, kAzimuths = 16;
  double sum = 0;
  for (int i = 0; i < kRings; ++i)
    for (int j = 0; j < kAzimuths; ++j) {
      const double sin2 = (i + 0.5) / kRings, phi = 2 * std::numbers::pi * (j + 0.5 * (i % 2)) / kAzimuths;
      const double s = std::sqrt(sin2);
      const double cosine = double{basis.normal.x} * s * std::cos(phi) + double{basis.normal.y} * s * std::sin(phi) +
                            double{basis.normal.z} * std::sqrt(1 - sin2);
      if (cosine <= 0 && cut_at_view_horizon(basis.lobe)) continue;
      const double t = std::sqrt(std::clamp(cosine, 0.0, 1.0)) * kNodes;
      const int node = std::min(static_cast<int>(t), kNodes - 1);
      const auto low = static_cast<size_t>(node);
      sum += curve[low] + (curve[low + 1] - curve[low]) * (t - node);
    }
  return sum / (kRings * kAzimuths);
}

FitSums fit_sums(const Spmm& spmm) {
  const size_t bases = spmm.dictionary.size();
  FitSums sums;
  sums.weights.assign(spmm.clusters.size() * bases, dvec3(0));
  sums.texels.assign(spmm.clusters.size(), 0);
  for (const tables::Texel& texel : spmm.texels) {
    const size_t cluster = texel.cluster_count & 0xffu, count = texel.cluster_count >> 8 & 0xffu;
    sums.texels[cluster] += 1;
    for (size_t i = texel.first_entry; i < texel.first_entry + count; ++i) {
      const tables::Entry& entry = spmm.entries[i];
      const auto half = [](uint32_t bits) { return double{float_from_half(static_cast<uint16_t>(bits))}; };
      sums.weights[cluster * bases + (entry.basis_red & 0xffffu)] +=
          dvec3(half(entry.basis_red >> 16), half(entry.green_blue & 0xffffu), half(entry.green_blue >> 16));
    }
  }
  for (const Basis& basis : spmm.dictionary) {
    sums.normal_albedo.push_back(normal_albedo(basis));
    sums.curves.push_back(albedo_curve(basis.lobe));
    sums.mean_reflectance.push_back(mean_reflectance(basis, sums.curves.back()));
    sums.sizes.push_back(lobe_size(basis.lobe));
  }
  sums.residual = residual_shares(spmm, sums.weights);
  return sums;
}

bool any_solo(const EditLayer& edits, int cluster) {
  const auto end = edits.bases.upper_bound({cluster, std::numeric_limits<int>::max()});
  for (auto row = edits.bases.lower_bound({cluster, 0}); row != end; ++row)
    if (row->second.solo) return true;
  return false;
}

vec3 effective_gain(const BasisEdit& edit, bool cluster_has_solo) {
  return edit.mute || (cluster_has_solo && !edit.solo) ? vec3(0) : edit.gain;
}

dvec3 cluster_reflectance(const Spmm& spmm, const EditLayer& edits, const FitSums& sums, int cluster,
                          AlbedoCurves& curves) {
  const bool solo = any_solo(edits, cluster);
  const size_t bases = spmm.dictionary.size();
  dvec3 total(0);
  for (size_t j = 0; j < bases; ++j) {
    const BasisKey key{cluster, static_cast<int>(j)};
    const BasisEdit edit = edits.edit_of(key);
    const bool reshaped = edit.lobe || edit.normal || edit.psi;
    double mean = sums.mean_reflectance[j];
    if (reshaped)
      mean = mean_reflectance(effective_basis(spmm, edits, key), edit.lobe ? curves.of(*edit.lobe) : sums.curves[j]);
    total += sums.weights[static_cast<size_t>(cluster) * bases + j] * dvec3(effective_gain(edit, solo)) * mean;
  }
  return total / std::max(sums.texels[static_cast<size_t>(cluster)], 1.0);
}

}  // namespace vamp
