#pragma once
// A mesostructure of our own: a periodic height field with a reflectance at each texel.
#include <cstdint>
#include <initializer_list>
#include <string>
#include <vector>

#include "engine/material/spmm.h"

namespace vamp::presets {

inline constexpr int kSide = 256;  // texels
inline constexpr int kFine = 2;    // height samples per texel and axis
inline constexpr int kFineSide = kSide * kFine;

// What lies at a texel: a matte body under a glossy finish. The finish is Cook-Torrance (along == across) or, for
// fibres, Ward with its own tangent.
struct Skin {
  vec3 albedo{0.5f};
  float gloss = 0;   // factor of the finish
  float f0 = 0.04f;  // Cook-Torrance only
  float along = 0.3f, across = 0.3f;
  float tangent = 0;  // radians, of a fibre
};

struct Surface {
  std::string name;
  double mm = 40;             // size of a period
  bool fibres = false;        // Ward instead of Cook-Torrance; Oren-Nayar body
  float sigma = 0;            // of the Oren-Nayar body, radians
  float fuzz = 0;             // single-scattering albedo of a thin layer of stray fibres over everything
  std::vector<float> height;  // mm, kFineSide^2
  std::vector<Skin> skin;     // kSide^2
  std::vector<uint8_t> cluster;
  std::vector<Cluster> clusters;
  std::vector<Basis> dictionary;
};

Surface make_calf(uint32_t seed);
Surface make_twill(uint32_t seed);

// A function of a dictionary: its frame tilted by `tilt` towards `azimuth`, its tangent turned by `psi`, all in
// degrees.
Basis tilted_basis(std::string name, Model model, std::initializer_list<float> params, double tilt, double azimuth,
                   double psi = 0);

// Unit normals of the texels: mean slope over each texel.
std::vector<vec3> texel_normals(const Surface& surface);

}  // namespace vamp::presets
