#pragma once
// What a designer changes over a fitted material: absolute values per (cluster, basis), and how the residual follows.
// It is what a preset stores, what undo walks and what the GPU applies (docs/design.md, "The edit layer").
#include <array>
#include <compare>
#include <map>
#include <optional>

#include "engine/core/vec.h"
#include "engine/material/spmm.h"

namespace vamp {

// One row of the basis table. Members that are not set keep the fit's value.
struct BasisEdit {
  vec3 gain{1, 1, 1};                             // multiplies the fitted weights; linear Rec.709
  std::optional<Lobe> lobe;                       // model, variant and parameters
  std::optional<vec3> normal;                     // unit, z > 0
  std::optional<float> psi;                       // radians
  bool mute = false, solo = false, lock = false;  // lock only guards against edits of a selection
  bool operator==(const BasisEdit&) const = default;
};

struct BasisKey {
  int cluster = 0, basis = 0;
  auto operator<=>(const BasisKey&) const = default;
};

enum class ResidualPolicy { follow, keep, fade };  // design.md, section 6

struct EditLayer {
  std::map<BasisKey, BasisEdit> bases;       // only rows that differ from the fit
  std::map<int, std::string> cluster_names;  // only those that were renamed
  int residual_terms = kMaxResidualTerms;    // PCA terms used: 0 is the mean alone
  float residual_strength = 1;               // 0 to 2
  ResidualPolicy residual_policy = ResidualPolicy::follow;
  bool operator==(const EditLayer&) const = default;

  BasisEdit edit_of(BasisKey key) const;
  void set(BasisKey key, const BasisEdit& edit);  // erases the row when it equals the fit
};

// The function of a cluster after its edit: what the table shows, and what is packed for the GPU.
Basis effective_basis(const Spmm& spmm, const EditLayer& edits, BasisKey key);

}  // namespace vamp
