#pragma once
// BRDFs as lists of measured samples, in the text format of ALTA (Belcour et al. 2017): a material of one texel.
#include <array>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/btf/btf.h"

namespace vamp {

struct BrdfSample {
  dvec3 wi, wo;                // to the light, to the viewer; phi of the light is 0
  std::array<float, 3> value;  // ReflectedCos; a file of one channel is grey
};

struct BrdfSamples {
  std::string name;
  std::vector<BrdfSample> samples;
  size_t left_out = 0;  // below the horizon, or so close to it that the measurement says nothing of f (cos < 0.02)
};

// Isotropic data in the parameters ISOTROPIC_TL_TV_PROJ_DPHI (theta of the light, then theta of the viewer times cosine
// and sine of the azimuth between them), as f (INV_STERADIAN) or f times the cosine of the viewer
// (INV_STERADIAN_COSINE_FACTOR: ALTA's "output direction"). bad_input: other parameters, damaged lines with their
// number.
Result<BrdfSamples> read_alta(const fs::path& path);
Result<BrdfSamples> parse_alta(std::string_view text, std::string_view file);

}  // namespace vamp
