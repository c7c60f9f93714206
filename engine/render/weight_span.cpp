#include "engine/render/weight_span.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <cstring>

#include "engine/material/tables.h"

namespace vamp {
namespace {

// What weighs a row: everything else of it says which function it is.
struct Weights {
  float red, green, blue;
  float operator[](int i) const { return i == 0 ? red : (i == 1 ? green : blue); }
};
Weights weights_of(const tables::BasisRow& row) { return {row.red, row.green, row.blue}; }
Weights weights_of(const tables::ClusterRow& row) { return {row.residual_red, row.residual_green, row.residual_blue}; }

void set_weights(tables::BasisRow& row, const Weights& w) { row.red = w.red, row.green = w.green, row.blue = w.blue; }
void set_weights(tables::ClusterRow& row, const Weights& w) {
  row.residual_red = w.red, row.residual_green = w.green, row.residual_blue = w.blue;
}

bool same_function(tables::BasisRow a, tables::BasisRow b) {
  set_weights(a, {});
  set_weights(b, {});
  return std::memcmp(&a, &b, sizeof(a)) == 0;
}

// Tables of the material with the group's gain at one value, whatever mutes it.
EditedTables at_gain(const MaterialInstance& material, const FitSums& sums, const std::vector<BasisKey>& rows,
                     vec3 gain) {
  EditLayer edits = material.edits;
  for (const BasisKey key : rows) {
    BasisEdit edit = edits.edit_of(key);
    edit.gain = gain;
    edit.mute = false;
    edits.set(key, edit);
  }
  return edited_tables(*material.fit, edits, &sums);
}

// Tables of all materials in which only the difference of two tables of one weighs anything.
template <class Row>
std::vector<Row> difference(const std::vector<Row>& all, uint32_t first, const std::vector<Row>& at_one,
                            const std::vector<Row>& at_zero) {
  std::vector<Row> rows = all;
  for (Row& row : rows) set_weights(row, {});
  for (size_t i = 0; i < at_one.size(); ++i) {
    const Weights a = weights_of(at_one[i]), b = weights_of(at_zero[i]);
    set_weights(rows[first + i], {a.red - b.red, a.green - b.green, a.blue - b.blue});
  }
  return rows;
}

template <class Row>
bool weighs(const Row& row) {
  const Weights w = weights_of(row);
  return w.red != 0 || w.green != 0 || w.blue != 0;
}

}  // namespace

WeightSpan::WeightSpan(const MaterialTables& tables, const Project& project, const WeightGroup& group)
    : material_(static_cast<size_t>(group.material)), place_(tables.places[material_]) {
  const MaterialInstance& material = project.materials[material_];
  const size_t bases = material.fit->dictionary.size();
  // No visible part shows it.
  if (!tables.sums[material_]) return;
  cluster_count_ = material.fit->clusters.size();
  basis_count_ = cluster_count_ * bases;
  start_from(tables);
  std::vector<BasisKey> rows;
  for (const BasisKey key : group.rows)
    if (key.cluster >= 0 && static_cast<size_t>(key.cluster) < cluster_count_ && key.basis >= 0 &&
        static_cast<size_t>(key.basis) < bases)
      rows.push_back(key);

  if (rows.empty()) return;
  const BasisEdit first = material.edits.edit_of(rows.front());
  const bool mixed = std::any_of(rows.begin(), rows.end(), [&](BasisKey key) {
    const BasisEdit edit = material.edits.edit_of(key);
    return edit.gain != first.gain || edit.mute != first.mute;
  });
  const vec3 gain = first.gain != vec3(0) ? first.gain : vec3(1);
  const FitSums& sums = *tables.sums[material_];
  const EditedTables common = at_gain(material, sums, rows, gain);
  const EditedTables zero = at_gain(material, sums, rows, vec3(0));
  if (mixed) add_direction(tables, common, {bases_, clusters_});
  add_direction(tables, common, zero);
  needed_ = directions_.size();
  // The brightest channel follows from the scale and the other two.
  const int brightest = gain.x >= std::max(gain.y, gain.z) ? 0 : (gain.y >= gain.z ? 1 : 2);
  for (int i = 1; i <= 2; ++i) {
    vec3 tint(0);
    tint[(brightest + i) % 3] = 1;
    add_direction(tables, at_gain(material, sums, rows, tint), zero);
  }
}

void WeightSpan::add_direction(const MaterialTables& tables, const EditedTables& to, const EditedTables& from) {
  Direction direction{difference(tables.bases, place_.basis, to.bases, from.bases),
                      difference(tables.clusters, place_.cluster, to.clusters, from.clusters)};
  const auto bases = static_cast<uint32_t>(basis_count_ / cluster_count_);
  uint32_t seen = 0;
  for (uint32_t i = 0; i < basis_count_; ++i)
    if (weighs(direction.bases[place_.basis + i])) seen |= seen_bit(material_, i / bases);
  for (uint32_t c = 0; c < cluster_count_; ++c)
    if (weighs(direction.clusters[place_.cluster + c])) seen |= seen_bit(material_, c);
  if (seen == 0) return;
  seen_ |= seen;
  directions_.push_back(std::move(direction));
}

void WeightSpan::start_from(const MaterialTables& now) {
  const auto rows_of = [](const auto& all, uint32_t first, size_t count) {
    const auto begin = all.begin() + static_cast<std::ptrdiff_t>(first);
    return std::remove_cvref_t<decltype(all)>(begin, begin + static_cast<std::ptrdiff_t>(count));
  };
  bases_ = rows_of(now.bases, place_.basis, basis_count_);
  clusters_ = rows_of(now.clusters, place_.cluster, cluster_count_);
}

std::optional<std::vector<double>> WeightSpan::steps_to(const MaterialTables& now, size_t ready) const {
  const auto count = static_cast<Eigen::Index>(std::min(ready, directions_.size()));
  if (count == 0) return std::nullopt;
  for (size_t i = 0; i < basis_count_; ++i)
    if (!same_function(now.bases[place_.basis + i], bases_[i])) return std::nullopt;

  // Calls visit(before, after, k -> weights of direction k) for each row of the material.
  const auto each_row = [&](const auto& visit) {
    for (size_t i = 0; i < basis_count_; ++i)
      visit(weights_of(bases_[i]), weights_of(now.bases[place_.basis + i]),
            [&](size_t k) { return weights_of(directions_[k].bases[place_.basis + i]); });
    for (size_t c = 0; c < cluster_count_; ++c)
      visit(weights_of(clusters_[c]), weights_of(now.clusters[place_.cluster + c]),
            [&](size_t k) { return weights_of(directions_[k].clusters[place_.cluster + c]); });
  };

  Eigen::MatrixXd products = Eigen::MatrixXd::Zero(count, count);
  Eigen::VectorXd moved = Eigen::VectorXd::Zero(count);
  each_row([&](const Weights& before, const Weights& after, const auto& along) {
    for (Eigen::Index k = 0; k < count; ++k) {
      const Weights d = along(static_cast<size_t>(k));
      for (int i = 0; i < 3; ++i) {
        moved[k] += double{d[i]} * (double{after[i]} - double{before[i]});
        for (Eigen::Index l = 0; l < count; ++l)
          products(k, l) += double{d[i]} * double{along(static_cast<size_t>(l))[i]};
      }
    }
  });
  const Eigen::VectorXd steps = products.completeOrthogonalDecomposition().solve(moved);

  bool all_of_the_way = true;
  each_row([&](const Weights& before, const Weights& after, const auto& along) {
    for (int i = 0; i < 3; ++i) {
      double reached = double{before[i]};
      double size = std::abs(double{before[i]}) + std::abs(double{after[i]});
      for (Eigen::Index k = 0; k < count; ++k) {
        const double part = steps[k] * double{along(static_cast<size_t>(k))[i]};
        reached += part;
        size += std::abs(part);
      }
      all_of_the_way = all_of_the_way && std::abs(reached - double{after[i]}) <= 0x1p-21 * size;
    }
  });
  if (!all_of_the_way) return std::nullopt;
  return std::vector<double>(steps.data(), steps.data() + steps.size());
}

}  // namespace vamp
