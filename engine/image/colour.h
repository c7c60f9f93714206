#pragma once
// Colour spaces of files: sRGB codes and the chromaticities of OpenEXR. Inside the program everything is linear
// Rec.709.
#include <array>
#include <span>
#include <vector>

namespace vamp {

// What the integer codes of a PNG or JPEG mean. Float files are always linear.
enum class ColourSpace {
  srgb,    // colours: decoded to linear Rec.709 (alpha stays linear)
  linear,  // data (normals, masks): code / highest code
};

// x and y of red, green, blue and white, as in OpenEXR. ITU-R BT.709 with D65.
inline constexpr std::array<float, 8> kRec709 = {0.64f, 0.33f, 0.3f, 0.6f, 0.15f, 0.06f, 0.3127f, 0.329f};

// decoded[code] for codes 0 to count - 1 (256 or 65536): the float nearest to the exact value.
std::vector<float> decoding_table(size_t count, ColourSpace space);

// Row-major 3 x 3 matrix from linear RGB of the given chromaticities to linear Rec.709, through XYZ with the Bradford
// adaptation of the white (ICC.1:2022, annex E). False when the chromaticities make no colour space.
bool matrix_to_rec709(const std::array<float, 8>& chromaticities, std::array<double, 9>& matrix);

}  // namespace vamp
