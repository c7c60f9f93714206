#pragma once
// How much light a fitted material's functions send back: what the residual's scale, the contribution column and the
// energy display are made of.
#include <vector>

#include "engine/material/edit_layer.h"

namespace vamp {

// Sums over a fit's texels that edits do not change. Make them once for a fit and pass them along: they cost a pass
// over all entries.
struct FitSums {
  std::vector<dvec3> weights;            // [cluster * bases + basis]: sum of the RGB weights over its texels
  std::vector<double> texels;            // [cluster]: number of texels
  std::vector<double> normal_albedo;     // [basis]: seen along the texel's normal
  std::vector<double> mean_reflectance;  // [basis]: see mean_reflectance() below
};
FitSums fit_sums(const Spmm& spmm);

// Mean over viewers, cosine-weighted about the texel's normal, of a function's albedo in its own tilted frame. Light
// that the texel's horizon hides from a tilted function is not subtracted. Good to about 1 %.
double mean_reflectance(const Basis& basis);

// Albedo of a function for a viewer along the texel's normal.
double normal_albedo(const Basis& basis);

// Mean RGB albedo of the parametric part of a cluster, edits included: cosine-weighted over viewers.
dvec3 cluster_reflectance(const Spmm& spmm, const EditLayer& edits, const FitSums& sums, int cluster);

// Whether a function of this cluster is soloed, which silences the cluster's others.
bool any_solo(const EditLayer& edits, int cluster);
// What multiplies a function's fitted weights after the edits: its gain, or 0 where it is muted or another is soloed.
vec3 effective_gain(const BasisEdit& edit, bool cluster_has_solo);

}  // namespace vamp
