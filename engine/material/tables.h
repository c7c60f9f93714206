#pragma once
// Fit + edit layer -> the rows that the kernels read.
#include <vector>

#include "engine/material/edit_layer.h"

namespace vamp {

// The part of the tables that edits change. Rows: cluster * dictionary.size() + basis.
struct EditedTables {
  std::vector<tables::BasisRow> bases;
  std::vector<tables::ClusterRow> clusters;
};
EditedTables edited_tables(const Spmm& spmm, const EditLayer& edits);

// The same with the fit's sums at hand (reflectance.h), which an edit that moves the residual otherwise makes anew;
// `sums` may be null.
struct FitSums;
EditedTables edited_tables(const Spmm& spmm, const EditLayer& edits, const FitSums* sums);

// Which models any basis of any cluster uses after the edits, a bit per Model; kernels leave the others out.
uint32_t models_in_use(const Spmm& spmm, const EditLayer& edits);
// The same as the LOBE_* mask of shaders/brdf/lobe.glsl.
uint32_t lobe_models_in_use(const Spmm& spmm, const EditLayer& edits);

// Direction interpolation for the residual (parabolic triangulation, extended past the last ring; algorithms.md 2.8).
inline constexpr int kDirectionMapSide = 256;
struct DirectionTables {
  std::vector<tables::DirectionTriangle> triangles;
  std::vector<uint16_t>
      map;  // kDirectionMapSide^2 triangle ids over the parabolic disk's square [-1, 1]^2, row-major in y
};
Result<DirectionTables> triangulate(const std::vector<vec3>& directions, std::string_view file);

// ReflectedCos of a texel in double: the oracle of the kernels. wi, wo unit, in the texel's frame.
dvec3 evaluate(const Spmm& spmm, const EditLayer& edits, const DirectionTables& directions, int x, int y, dvec3 wi,
               dvec3 wo);
// The same from tables made before, for many evaluations of one state.
dvec3 evaluate(const Spmm& spmm, const EditedTables& edited, int residual_terms, const DirectionTables& directions,
               int x, int y, dvec3 wi, dvec3 wo);

// Share of a cluster's energy that each basis carries after the edits, summing to 1 (contribution column of the table):
// weight sums over the cluster's texels times the lobe's albedo at normal view, as luminance.
std::vector<float> contributions(const Spmm& spmm, const EditLayer& edits, int cluster);
std::vector<float> contributions(const Spmm& spmm, const EditLayer& edits, int cluster, const FitSums& sums);

// What a material's tables take on the GPU, direction tables included.
uint64_t bytes_on_gpu(const Spmm& spmm);

}  // namespace vamp
