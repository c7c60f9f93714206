#pragma once
// From the channels of a file to the three values of a Btf: undoes the colour model, turns wavelengths into Rec.709 and
// multiplies with the cosine of the light where the file leaves it out.
#include <span>
#include <string_view>
#include <vector>

#include "engine/btf/factored_btf.h"

namespace vamp {

class SampleColour {
 public:
  // bad_input when the channels are neither R, G, B nor rising wavelengths in nm.
  static Result<SampleColour> of(const FactoredBtf& factored, std::string_view file);
  static Result<SampleColour> of(std::span<const std::string> channels, const BtfInfo& info, bool has_cosine,
                                 const ColourTransform& transform, std::string_view file);

  // `channels` is used up; false when the result is not finite.
  bool convert(std::span<double> channels, size_t light, std::span<float, 3> rgb) const;

 private:
  ColourTransform transform_;
  std::vector<double> matrix_;  // 3 x channels, row-major; empty: the three channels as they are
  std::vector<double> factor_;  // per light
};

}  // namespace vamp
