#include "engine/fit/represent.h"

#include <algorithm>
#include <cmath>

#include "engine/core/half.h"
#include "engine/material/directions.h"
#include "engine/material/reflectance.h"

namespace vamp::fit {
namespace {

float half(uint32_t bits) { return float_from_half(static_cast<uint16_t>(bits & 0xffffu)); }

bool same(vec3 a, vec3 b) {
  return std::abs(a.x - b.x) < 1e-4f && std::abs(a.y - b.y) < 1e-4f && std::abs(a.z - b.z) < 1e-4f;
}

}  // namespace

Result<Interpolation> interpolate(const std::vector<vec3>& from, const std::vector<vec3>& to) {
  VAMP_TRY(const DirectionTables tables, triangulate(from, "directions"));
  Interpolation out;
  for (const vec3& direction : to) {
    const auto found = find_direction(tables, dvec3(direction));
    out.slots.push_back(found.slot);
    out.weights.push_back({static_cast<float>(found.weight[0]), static_cast<float>(found.weight[1]),
                           static_cast<float>(found.weight[2])});
    // Exactly what was measured where it was measured.
    for (size_t i = 0; i < from.size(); ++i)
      if (same(from[i], direction)) {
        out.slots.back() = {static_cast<int>(i), 0, 0};
        out.weights.back() = {1, 0, 0};
      }
  }
  return out;
}

Result<Rows> resample(const Rows& rows, const std::vector<vec3>& from, const Pairs& to) {
  VAMP_TRY(const Interpolation views, interpolate(from, to.views));
  VAMP_TRY(const Interpolation lights, interpolate(from, to.lights));
  const float last = last_ring_cosine(from);
  const size_t n = from.size(), pairs = to.count();
  Rows out(rows.count, 3 * pairs);
  for (size_t r = 0; r < rows.count; ++r)
    for (size_t c = 0; c < 3; ++c) {
      const float* values = rows.row(r) + c * n * n;
      float* to_row = out.row(r) + c * pairs;
      for (size_t v = 0; v < to.views.size(); ++v)
        for (size_t l = 0; l < to.lights.size(); ++l) {
          float sum = 0;
          for (size_t i = 0; i < 3; ++i)
            for (size_t j = 0; j < 3; ++j)
              sum += views.weights[v][i] * lights.weights[l][j] *
                     values[static_cast<size_t>(views.slots[v][i]) * n + static_cast<size_t>(lights.slots[l][j])];
          to_row[v * to.lights.size() + l] = sum * std::min(1.f, to.lights[l].z / last);
        }
    }
  return out;
}

Result<SpmmValues> SpmmValues::make(const Spmm& spmm, const Pairs& pairs, const EditLayer& edits) {
  SpmmValues values;
  values.spmm_ = &spmm;
  const size_t bases = spmm.dictionary.size();
  std::vector<Basis> shapes = spmm.dictionary;
  for (size_t c = 0; c < spmm.clusters.size(); ++c) {
    const bool solo = any_solo(edits, static_cast<int>(c));
    for (size_t j = 0; j < bases; ++j) {
      const BasisKey key{static_cast<int>(c), static_cast<int>(j)};
      Basis basis = effective_basis(spmm, edits, key);
      const bool reshaped = !(basis == spmm.dictionary[j]);
      values.column_of_.push_back(static_cast<uint32_t>(reshaped ? shapes.size() : j));
      values.gains_.push_back(effective_gain(edits.edit_of(key), solo));
      if (reshaped) shapes.push_back(std::move(basis));
    }
  }
  values.columns_ = Rows(shapes.size(), pairs.count());
  for (size_t j = 0; j < shapes.size(); ++j) evaluate_column(shapes[j], pairs, nullptr, values.columns_.row(j));
  if (spmm.residual.records.empty()) return values;
  const size_t n = spmm.residual.directions.size(), each = static_cast<size_t>(spmm.residual.terms) + 1;
  values.terms_ = std::min(edits.residual_terms, spmm.residual.terms);
  const EditedTables edited = edited_tables(spmm, edits);
  Rows records(spmm.clusters.size() * each, 3 * n * n);
  for (size_t c = 0; c < spmm.clusters.size(); ++c) {
    const tables::ClusterRow& row = edited.clusters[c];
    const std::array<float, 3> scale = {row.residual_red, row.residual_green, row.residual_blue};
    for (size_t pair = 0; pair < n * n; ++pair) {
      const tables::ResidualRecord& record = spmm.residual.records[c * n * n + pair];
      for (size_t i = 0; i < 3 * each; ++i)
        records.row(c * each + i / 3)[i % 3 * n * n + pair] = scale[i % 3] * half(record.halves[i / 2] >> (i % 2 * 16));
    }
  }
  VAMP_TRY(values.residual_, resample(records, spmm.residual.directions, pairs));
  return values;
}

void SpmmValues::functions(size_t texel, float* out) const {
  const tables::Texel& row = spmm_->texels[texel];
  const size_t pairs = columns_.length;
  std::fill(out, out + 3 * pairs, 0.f);
  const size_t first = (row.cluster_count & 0xffu) * spmm_->dictionary.size();
  for (size_t i = 0; i < (row.cluster_count >> 8 & 0xffu); ++i) {
    const tables::Entry& entry = spmm_->entries[row.first_entry + i];
    const size_t at = first + (entry.basis_red & 0xffffu);
    const vec3 gain = gains_[at];
    const std::array<float, 3> weights = {gain.x * half(entry.basis_red >> 16), gain.y * half(entry.green_blue),
                                          gain.z * half(entry.green_blue >> 16)};
    add_combinations(weights.data(), 3, columns_.row(column_of_[at]), 1, pairs, out);
  }
}

void SpmmValues::add_residual(size_t texel, int k, float* out) const {
  const tables::Texel& row = spmm_->texels[texel];
  const size_t each = static_cast<size_t>(spmm_->residual.terms) + 1, cluster = row.cluster_count & 0xffu;
  const std::array<float, 5> factors = {1, half(row.coefficients01), half(row.coefficients01 >> 16),
                                        half(row.coefficients23), half(row.coefficients23 >> 16)};
  add_combinations(&factors[static_cast<size_t>(k)], 1, residual_.row(cluster * each + static_cast<size_t>(k)), 1,
                   residual_.length, out);
}

}  // namespace vamp::fit
