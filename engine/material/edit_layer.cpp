#include "engine/material/edit_layer.h"

#include "engine/core/check.h"

namespace vamp {

BasisEdit EditLayer::edit_of(BasisKey key) const {
  const auto found = bases.find(key);
  return found == bases.end() ? BasisEdit{} : found->second;
}

void EditLayer::set(BasisKey key, const BasisEdit& edit) {
  if (edit == BasisEdit{})
    bases.erase(key);
  else
    bases[key] = edit;
}

Basis effective_basis(const Spmm& spmm, const EditLayer& edits, BasisKey key) {
  CHECK(key.basis >= 0 && static_cast<size_t>(key.basis) < spmm.dictionary.size());
  Basis basis = spmm.dictionary[static_cast<size_t>(key.basis)];
  const auto found = edits.bases.find(key);
  if (found == edits.bases.end()) return basis;
  basis.lobe = found->second.lobe.value_or(basis.lobe);
  basis.normal = found->second.normal.value_or(basis.normal);
  basis.psi = found->second.psi.value_or(basis.psi);
  return basis;
}

}  // namespace vamp
