#pragma once
// The Sparse Parametric Mixture Model of a BTF (Wu et al. 2011; Silva & Santos 2013, eq. 1 to 3) as it is fitted:
//   ReflectedCos(t, wi, wo) = sum_j alpha_j(t) rho_j(wi, wo) + mean_c(wi, wo) + sum_k coef_k(t) b_ck(wi, wo).
// A fit is never changed: what a designer does is an edit layer over it (edit_layer.h).
#include <memory>
#include <string>
#include <vector>

#include "engine/brdf/lobe.h"
#include "engine/core/error.h"
#include "engine/core/vec.h"
#include "shaders/shared/tables.h"

namespace vamp {

// One rotated, cosine-weighted BRDF of the dictionary.
struct Basis {
  std::string name;      // what a designer calls it: "body", "grain sheen"
  Lobe lobe;             // its ks and rho are 1: the weights carry scale and colour
  vec3 normal{0, 0, 1};  // frame normal n_j in the texel's frame, unit, z > 0
  float psi = 0;         // tangent angle about n_j in radians
  bool operator==(const Basis&) const = default;
};

struct Cluster {
  std::string name;  // "grain", "pore"
  bool operator==(const Cluster&) const = default;
};

inline constexpr int kMaxClusters = 256;
inline constexpr int kMaxBases = 65535;
inline constexpr int kMaxDirections = 1023;  // three indices share 32 bits
inline constexpr int kMaxResidualTerms = 4;
inline constexpr int kMaxTexelSide = 8192;

// Residual over (view, light) pairs of one measured direction set.
struct Residual {
  std::vector<vec3> directions;                 // unit, upper hemisphere; the same set for views and lights
  int terms = 0;                                // PCA terms that the records hold, 0 to 4
  std::vector<tables::ResidualRecord> records;  // [cluster][view][light]; empty when there is no residual
};

struct Spmm {
  int width = 0, height = 0;  // texels; row 0 at v = 0
  float mm_per_texel = 0.1f;
  std::vector<Basis> dictionary;  // shared by all clusters
  std::vector<Cluster> clusters;
  std::vector<tables::Texel> texels;  // width * height, row-major
  std::vector<tables::Entry> entries;
  Residual residual;

  vec2 size_mm() const { return {static_cast<float>(width) * mm_per_texel, static_cast<float>(height) * mm_per_texel}; }
};

using SpmmPtr = std::shared_ptr<const Spmm>;

// Everything that must hold for the kernels to read inside their tables and get finite numbers.
Status validate(const Spmm& spmm, std::string_view file);

}  // namespace vamp
