#pragma once
// How much light a fitted material's functions send back: what the contribution column and the energy display are made
// of.
#include <array>
#include <deque>
#include <utility>
#include <vector>

#include "engine/material/edit_layer.h"
#include "engine/material/residual_follow.h"

namespace vamp {

// A lobe's albedo over the viewer's cosine, at cosines (i / 16)^2, i = 0 to 16: it is smooth, and denser towards
// grazing where it bends. Dear to make (quadratures), cheap to use.
using AlbedoCurve = std::array<double, 17>;
AlbedoCurve albedo_curve(const Lobe& lobe);

// The curves of lobes met so far: an edit often gives one lobe to many clusters.
class AlbedoCurves {
 public:
  const AlbedoCurve& of(const Lobe& lobe);

 private:
  std::deque<std::pair<Lobe, AlbedoCurve>> known_;
};

// Sums over a fit's texels that edits do not change. Make them once for a fit and pass them along: they cost a pass
// over all entries.
struct FitSums {
  std::vector<dvec3> weights;            // [cluster * bases + basis]: sum of the RGB weights over its texels
  std::vector<double> texels;            // [cluster]: number of texels
  std::vector<double> normal_albedo;     // [basis]: seen along the texel's normal
  std::vector<AlbedoCurve> curves;       // [basis]
  std::vector<double> mean_reflectance;  // [basis]: see mean_reflectance() below
  std::vector<double> sizes;             // [basis]: see lobe_size() in residual_follow.h
  ResidualShares residual;               // see there
};
FitSums fit_sums(const Spmm& spmm);

// Mean over viewers, cosine-weighted about the texel's normal, of a function's albedo in its own tilted frame; `curve`
// is its lobe's. Light that the texel's horizon hides from a tilted function is not subtracted. Good to about 1 %.
double mean_reflectance(const Basis& basis, const AlbedoCurve& curve);

// Albedo of a function for a viewer along the texel's normal.
double normal_albedo(const Basis& basis);

// Mean RGB albedo of the parametric part of a cluster, edits included: cosine-weighted over viewers.
dvec3 cluster_reflectance(const Spmm& spmm, const EditLayer& edits, const FitSums& sums, int cluster,
                          AlbedoCurves& curves);

// Whether a function of this cluster is soloed, which silences the cluster's others.
bool any_solo(const EditLayer& edits, int cluster);
// What multiplies a function's fitted weights after the edits: its gain, or 0 where it is muted or another is soloed.
vec3 effective_gain(const BasisEdit& edit, bool cluster_has_solo);

}  // namespace vamp
