#include "engine/project/fit_checksum.h"

#include <fmt/format.h>

#include <span>

#include "engine/core/hash.h"

namespace vamp {

std::string fit_checksum(const Spmm& spmm) {
  uint64_t hash = 0;
  const auto add = [&hash](const auto* first, size_t count) {
    hash = hash64(std::as_bytes(std::span(first, count)), hash);
  };
  const int32_t sizes[] = {spmm.width, spmm.height, static_cast<int32_t>(spmm.clusters.size()),
                           static_cast<int32_t>(spmm.dictionary.size()), spmm.residual.terms};
  add(sizes, std::size(sizes));
  add(&spmm.mm_per_texel, 1);
  // Member by member: a Basis has padding, which has no value.
  for (const Basis& basis : spmm.dictionary) {
    const uint8_t kind[] = {static_cast<uint8_t>(basis.lobe.model), basis.lobe.variant};
    add(kind, 2);
    add(basis.lobe.params.data(), basis.lobe.params.size());
    const float frame[] = {basis.normal.x, basis.normal.y, basis.normal.z, basis.psi};
    add(frame, 4);
  }
  add(spmm.texels.data(), spmm.texels.size());
  add(spmm.entries.data(), spmm.entries.size());
  add(spmm.residual.directions.data(), spmm.residual.directions.size());
  add(spmm.residual.records.data(), spmm.residual.records.size());
  return fmt::format("{:016x}", hash);
}

}  // namespace vamp
