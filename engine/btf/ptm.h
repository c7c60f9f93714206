#pragma once
// Polynomial Texture Maps (Malzbender, Gelb, Wolters 2001), file format 1.2: per texel six coefficients of a
// biquadratic in the light's x and y, for luminance (LRGB) or for each colour (RGB). One view; values are display
// codes.
#include <array>
#include <span>
#include <vector>

#include "engine/btf/btf.h"
#include "engine/btf/image_folder.h"

namespace vamp {

struct Ptm {
  bool has_luminance = true;  // LRGB: colour * luminance; else three polynomials
  uint32_t width = 0, height = 0;
  std::array<float, 6> scale{};  // coefficient = (byte - bias) * scale
  std::array<int, 6> bias{};
  // Rows from the top. LRGB: [texel][6]; RGB: [channel][texel][6].
  std::vector<uint8_t> coefficients;
  std::vector<uint8_t> colours;  // LRGB: [texel][3]

  size_t texel_count() const { return size_t{width} * height; }
  // The code, 255 being white, not cut off:
  // a0 x^2 + a1 y^2 + a2 x y + a3 x + a4 y + a5 (Malzbender et al., eq. 4).
  double value(size_t texel, size_t channel, const dvec3& light) const;
};

// bad_input: no PTM 1.2, damaged, another number of bytes than the size says, one of the JPEG formats.
Result<Ptm> read_ptm(const fs::path& path);
Result<Ptm> read_ptm(std::span<const std::byte> bytes, std::string_view file);
Status write_ptm(const fs::path& path, const Ptm& ptm);

// A BTF of one view that shows the map under these lights; codes become light by `curve`, negative ones 0.
BtfInfo info_of(const Ptm& ptm, DirectionSet lights);
void decode(const Ptm& ptm, Btf& out, PictureCurve curve);

// Least squares over the codes of these lights of a fixed-view BTF; coefficients are rounded to what the format holds.
// At least 6 lights that do not lie on one conic: failed otherwise.
Result<Ptm> fit_ptm(const Btf& btf, std::span<const size_t> lights, bool has_luminance, PictureCurve curve);

}  // namespace vamp
