#include <cmath>

#include "engine/core/check.h"
#include "engine/material/reflectance.h"
#include "engine/material/residual_follow.h"
#include "engine/material/tables.h"

namespace vamp {
namespace {

tables::BasisRow basis_row(const Basis& basis, const PackedLobe& packed, vec3 gain) {
  const vec3 factor = gain * packed.scale;
  return {basis.normal.x,
          basis.normal.y,
          std::cos(basis.psi),
          std::sin(basis.psi),
          packed.k[0],
          packed.k[1],
          packed.k[2],
          packed.k[3],
          factor.x,
          factor.y,
          factor.z,
          packed.tag};
}

}  // namespace

EditedTables edited_tables(const Spmm& spmm, const EditLayer& edits) { return edited_tables(spmm, edits, nullptr); }

EditedTables edited_tables(const Spmm& spmm, const EditLayer& edits, const FitSums* sums) {
  const size_t bases = spmm.dictionary.size();
  EditedTables out;
  out.bases.reserve(spmm.clusters.size() * bases);
  std::vector<tables::BasisRow> fitted;
  for (const Basis& basis : spmm.dictionary) fitted.push_back(basis_row(basis, pack_lobe(basis.lobe), vec3(1)));
  for (size_t c = 0; c < spmm.clusters.size(); ++c) out.bases.insert(out.bases.end(), fitted.begin(), fitted.end());
  const float strength = edits.residual_strength;
  out.clusters.assign(spmm.clusters.size(), {strength, strength, strength, 0});

  std::optional<FitSums> own;
  LobeSizes sizes;
  for (auto row = edits.bases.begin(); row != edits.bases.end();) {
    const int cluster = row->first.cluster;
    CHECK(cluster >= 0 && static_cast<size_t>(cluster) < spmm.clusters.size());
    const bool solo = any_solo(edits, cluster);
    tables::BasisRow* const first = out.bases.data() + static_cast<size_t>(cluster) * bases;
    if (solo)
      for (size_t j = 0; j < bases; ++j) first[j].red = first[j].green = first[j].blue = 0;
    bool changed = solo;
    for (; row != edits.bases.end() && row->first.cluster == cluster; ++row) {
      const Basis basis = effective_basis(spmm, edits, row->first);
      first[row->first.basis] = basis_row(basis, pack_lobe(basis.lobe), effective_gain(row->second, solo));
      BasisEdit unlocked = row->second;
      unlocked.lock = false;
      changed |= unlocked != BasisEdit{};
    }
    if (!changed || spmm.residual.records.empty() || edits.residual_policy == ResidualPolicy::keep) continue;
    if (sums == nullptr) sums = &own.emplace(fit_sums(spmm));
    const vec3 scale = vec3(residual_scale(spmm, edits, *sums, cluster, sizes)) * strength;
    out.clusters[static_cast<size_t>(cluster)] = {scale.x, scale.y, scale.z, 0};
  }
  return out;
}

uint32_t models_in_use(const Spmm& spmm, const EditLayer& edits) {
  uint32_t mask = 0;
  for (const Basis& basis : spmm.dictionary) mask |= 1u << static_cast<uint32_t>(basis.lobe.model);
  for (const auto& [key, edit] : edits.bases)
    if (edit.lobe) mask |= 1u << static_cast<uint32_t>(edit.lobe->model);
  return mask;
}

uint32_t lobe_models_in_use(const Spmm& spmm, const EditLayer& edits) {
  uint32_t mask = 0;
  for (const Basis& basis : spmm.dictionary) mask |= lobe_models_bit(basis.lobe);
  for (const auto& [key, edit] : edits.bases)
    if (edit.lobe) mask |= lobe_models_bit(*edit.lobe);
  return mask;
}

std::vector<float> contributions(const Spmm& spmm, const EditLayer& edits, int cluster) {
  return contributions(spmm, edits, cluster, fit_sums(spmm));
}

std::vector<float> contributions(const Spmm& spmm, const EditLayer& edits, int cluster, const FitSums& sums) {
  const size_t bases = spmm.dictionary.size();
  const bool solo = any_solo(edits, cluster);
  std::vector<double> energy(bases);
  double total = 0;
  for (size_t j = 0; j < bases; ++j) {
    const BasisKey key{cluster, static_cast<int>(j)};
    const BasisEdit edit = edits.edit_of(key);
    const double albedo =
        edit.lobe || edit.normal ? normal_albedo(effective_basis(spmm, edits, key)) : sums.normal_albedo[j];
    const dvec3 weight = sums.weights[static_cast<size_t>(cluster) * bases + j] * dvec3(effective_gain(edit, solo));
    energy[j] = std::abs((0.2126 * weight.x + 0.7152 * weight.y + 0.0722 * weight.z) * albedo);
    total += energy[j];
  }
  std::vector<float> shares(bases);
  for (size_t j = 0; j < bases; ++j) shares[j] = total > 0 ? static_cast<float>(energy[j] / total) : 0.f;
  return shares;
}

uint64_t bytes_on_gpu(const Spmm& spmm) {
  const uint64_t rows = spmm.clusters.size() * spmm.dictionary.size();
  uint64_t bytes = spmm.texels.size() * sizeof(tables::Texel) + spmm.entries.size() * sizeof(tables::Entry) +
                   rows * sizeof(tables::BasisRow) + spmm.clusters.size() * sizeof(tables::ClusterRow);
  if (!spmm.residual.records.empty()) {
    // A triangulation of n points and 24 virtual ones has 2 (n + 24) - 2 - 24 triangles.
    const uint64_t triangles = 2 * (spmm.residual.directions.size() + 24) - 26;
    bytes += spmm.residual.records.size() * sizeof(tables::ResidualRecord) +
             triangles * sizeof(tables::DirectionTriangle) +
             uint64_t{kDirectionMapSide} * kDirectionMapSide * sizeof(uint16_t);
  }
  return bytes;
}

}  // namespace vamp
