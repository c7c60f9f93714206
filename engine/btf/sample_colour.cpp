#include "engine/btf/sample_colour.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace vamp {
namespace {

// Empty unless all names are rising wavelengths in nm: "400", "410.5nm".
std::vector<double> wavelengths(std::span<const std::string> names) {
  std::vector<double> nm;
  for (const std::string& name : names) {
    double value = 0;
    const auto [end, code] = std::from_chars(name.data(), name.data() + name.size(), value);
    const std::string_view rest(end, name.data() + name.size());
    const bool unit = rest.empty() || rest == "nm" || rest == " nm";
    if (code != std::errc() || !unit || value < 200 || value > 3000 || (!nm.empty() && value <= nm.back())) return {};
    nm.push_back(value);
  }
  return nm;
}

}  // namespace

Result<SampleColour> SampleColour::of(const FactoredBtf& factored, std::string_view file) {
  return of(factored.channels, factored.info, factored.has_cosine, factored.colour, file);
}

Result<SampleColour> SampleColour::of(std::span<const std::string> channels, const BtfInfo& info, bool has_cosine,
                                      const ColourTransform& transform, std::string_view file) {
  SampleColour colour;
  colour.transform_ = transform;
  const std::vector<double> nm = wavelengths(channels);
  if (!nm.empty()) {
    colour.matrix_ = rec709_from_wavelengths(nm);
  } else if (channels.size() != 3) {
    return fail(ErrorKind::bad_input, file, "channels", "three, or rising wavelengths in nm",
                fmt::format("{} channels, the first \"{}\"", channels.size(), channels[0]));
  }
  for (const dvec3& light : info.lights.directions)
    colour.factor_.push_back(has_cosine || info.colour == BtfColour::log_yuv ? 1 : light.z);
  return colour;
}

bool SampleColour::convert(std::span<double> channels, size_t light, std::span<float, 3> rgb) const {
  undo(transform_, channels);
  bool finite = true;
  for (size_t i = 0; i < 3; ++i) {
    double value = channels[i];
    if (!matrix_.empty()) {
      value = 0;
      for (size_t c = 0; c < channels.size(); ++c) value += matrix_[i * channels.size() + c] * channels[c];
    }
    rgb[i] = static_cast<float>(value * factor_[light]);
    finite = finite && std::isfinite(rgb[i]);
  }
  return finite;
}

}  // namespace vamp
