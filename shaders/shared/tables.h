// The material tables as the kernels read them: rows of 16-byte texels, so that they can be fetched through texel buffers
// (nearly twice as fast as storage buffers on Mesa 22's lavapipe).
// Read by GLSL and C++. No padding, 4-byte members, no bool.
#ifdef __cplusplus
#pragma once
#include <cstdint>
namespace vamp::tables {
using uint = std::uint32_t;
#endif

// One texel of a material: RGBA32UI.
struct Texel {
  uint first_entry;    // index of its first entry, relative to the material's
  uint cluster_count;  // cluster in bits 0..7, number of entries in bits 8..15
  uint coefficients01; // residual PCA coefficients, 4 halves
  uint coefficients23;
};

// One weighted function of a texel: RG32UI.
struct Entry {
  uint basis_red;   // index into the material's dictionary in bits 0..15, red weight as a half in bits 16..31
  uint green_blue;  // halves
};

// What a dictionary's function comes to in one cluster after the edit layer: 3 x RGBA32F. Row = cluster * bases + basis.
struct BasisRow {
  float normal_x, normal_y;      // frame normal n_j, z = sqrt(1 - x^2 - y^2) > 0
  float cos_psi, sin_psi;        // tangent angle
  float k0, k1, k2, k3;          // the packed lobe's constants (engine/brdf/lobe.h)
  float red, green, blue;        // edit gain times the lobe's constant factor
  uint tag;                      // the packed lobe's code path and variant
};

// What the edit layer does to a cluster's residual: RGBA32F.
struct ClusterRow {
  float residual_red, residual_green, residual_blue;
  float unused;
};

// One residual record, at (cluster * directions + view) * directions + light: 16 halves = 2 x RGBA32UI.
// mean.rgb, b1.rgb, b2.rgb, b3.rgb, b4.rgb, 0. View and light are indices of the material's direction set.
struct ResidualRecord {
  uint halves[8];
};

// One triangle of a direction set on the parabolic disk p = (x, y) / (1 + z): 2 x RGBA32F.
// lambda1 = row1 . (p, 1), lambda2 = row2 . (p, 1), lambda3 = 1 - lambda1 - lambda2; then clamped and renormalised.
struct DirectionTriangle {
  float row1[3];
  uint slots;  // three direction indices, 10 bits each, vertex 1 in the low bits
  float row2[3];
  uint unused;
};

#ifdef __cplusplus
static_assert(sizeof(Texel) == 16 && sizeof(Entry) == 8 && sizeof(BasisRow) == 48 && sizeof(ClusterRow) == 16);
static_assert(sizeof(ResidualRecord) == 32 && sizeof(DirectionTriangle) == 32);
}  // namespace vamp::tables
#endif
