// The oracle of the kernels: everything in double, from the same stored numbers.
#include <cmath>

#include "engine/core/check.h"
#include "engine/core/half.h"
#include "engine/material/directions.h"
#include "engine/material/frame.h"
#include "engine/material/tables.h"

namespace vamp {
namespace {

double half(uint32_t bits) { return double{float_from_half(static_cast<uint16_t>(bits & 0xffffu))}; }

dvec3 normalised(dvec3 v) { return v / std::sqrt(v.x * v.x + v.y * v.y + v.z * v.z); }
dvec3 residual_value(const Spmm& spmm, const tables::Texel& texel, const DirectionTables& directions, int terms,
                     dvec3 wi, dvec3 wo) {
  const auto views = find_direction(directions, wo), lights = find_direction(directions, wi);
  const std::array<double, 4> coefficients = {half(texel.coefficients01), half(texel.coefficients01 >> 16),
                                              half(texel.coefficients23), half(texel.coefficients23 >> 16)};
  const size_t count = spmm.residual.directions.size(), cluster = texel.cluster_count & 0xffu;
  dvec3 sum(0);
  for (size_t v = 0; v < 3; ++v)
    for (size_t l = 0; l < 3; ++l) {
      const auto& record = spmm.residual.records[(cluster * count + static_cast<size_t>(views.slot[v])) * count +
                                                 static_cast<size_t>(lights.slot[l])];
      const auto at = [&](int i) { return half(record.halves[i / 2] >> (i % 2 * 16)); };
      dvec3 value(at(0), at(1), at(2));
      for (int k = 0; k < terms; ++k)
        value += coefficients[static_cast<size_t>(k)] * dvec3(at(3 * k + 3), at(3 * k + 4), at(3 * k + 5));
      sum += views.weight[v] * lights.weight[l] * value;
    }
  return sum * std::min(1.0, wi.z / double{last_ring_cosine(spmm.residual.directions)});
}

}  // namespace

dvec3 evaluate(const Spmm& spmm, const EditLayer& edits, const DirectionTables& directions, int x, int y, dvec3 wi,
               dvec3 wo) {
  return evaluate(spmm, edited_tables(spmm, edits), edits.residual_terms, directions, x, y, wi, wo);
}

dvec3 evaluate(const Spmm& spmm, const EditedTables& edited, int residual_terms, const DirectionTables& directions,
               int x, int y, dvec3 wi, dvec3 wo) {
  CHECK(x >= 0 && y >= 0 && x < spmm.width && y < spmm.height);
  wi = normalised(wi), wo = normalised(wo);
  // Macro horizon: nothing of a material is seen from below or lit from below.
  if (!(wi.z > 0 && wo.z > 0)) return dvec3(0);
  const tables::Texel& texel =
      spmm.texels[static_cast<size_t>(y) * static_cast<size_t>(spmm.width) + static_cast<size_t>(x)];
  const size_t cluster = texel.cluster_count & 0xffu, count = texel.cluster_count >> 8 & 0xffu;
  dvec3 sum(0);
  for (size_t i = texel.first_entry; i < texel.first_entry + count; ++i) {
    const tables::Entry& entry = spmm.entries[i];
    const tables::BasisRow& row = edited.bases[cluster * spmm.dictionary.size() + (entry.basis_red & 0xffffu)];
    const BasisFrame frame(double{row.normal_x}, double{row.normal_y}, double{row.cos_psi}, double{row.sin_psi});
    // The row's colour holds the lobe's constant factor already.
    const PackedLobe lobe{row.tag, {row.k0, row.k1, row.k2, row.k3}, 1.f};
    const double value = lobe_value(lobe, frame.local(wi), frame.local(wo));
    sum += dvec3(half(entry.basis_red >> 16), half(entry.green_blue), half(entry.green_blue >> 16)) *
           dvec3(double{row.red}, double{row.green}, double{row.blue}) * value;
  }
  if (!spmm.residual.records.empty()) {
    const tables::ClusterRow& row = edited.clusters[cluster];
    const dvec3 scale(double{row.residual_red}, double{row.residual_green}, double{row.residual_blue});
    sum += scale * residual_value(spmm, texel, directions, std::min(residual_terms, spmm.residual.terms), wi, wo);
  }
  return sum;
}

}  // namespace vamp
