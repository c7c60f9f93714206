#pragma once
// Which tables the weights at hand can be pulled to: an edit of weights moves the tables along straight lines, and so
// the picture, which is linear in them.
#include <cstdint>
#include <optional>
#include <vector>

#include "engine/material/tables.h"
#include "engine/render/material_tables.h"

namespace vamp {

// Rows of a material whose gains may be edited next, all by one value: what is selected in the editor.
struct WeightGroup {
  int material = -1;
  std::vector<BasisKey> rows;
  bool operator==(const WeightGroup&) const = default;
};

// How the tables of all materials move with the gain of a group. Where its rows have different gains, the first
// direction leads to one gain for all. Then comes the one that scales it, or white where it is black, and two that tint
// it. Directions that move nothing are left out.
class WeightSpan {
 public:
  // `tables` are the project's. Rows that the material does not have are ignored.
  WeightSpan(const MaterialTables& tables, const Project& project, const WeightGroup& group);

  // The tables to shade a direction with: the same functions, weighed by how much a step of 1 adds.
  struct Direction {
    std::vector<tables::BasisRow> bases;
    std::vector<tables::ClusterRow> clusters;
  };
  const std::vector<Direction>& directions() const { return directions_; }
  // Of which so many are needed to make all channels lighter or darker.
  size_t needed() const { return needed_; }
  // Clusters that move, as bits of what pixels have seen.
  uint32_t seen() const { return seen_; }

  // Steps along the first `ready` directions from the tables of the constructor (or of start_from) to those of now;
  // nothing if they are not all of the way, to 2^-21 of each row.
  std::optional<std::vector<double>> steps_to(const MaterialTables& now, size_t ready) const;
  // Steps count from here: only weights have changed.
  void start_from(const MaterialTables& now);

 private:
  void add_direction(const MaterialTables& tables, const EditedTables& to, const EditedTables& from);

  size_t material_;
  MaterialTables::Place place_;
  size_t basis_count_ = 0, cluster_count_ = 0;  // rows of the material
  std::vector<tables::BasisRow> bases_;         // of the material, where steps count from
  std::vector<tables::ClusterRow> clusters_;
  std::vector<Direction> directions_;
  size_t needed_ = 0;
  uint32_t seen_ = 0;
};

}  // namespace vamp
