#pragma once
// Two pictures against each other: what `vamp compare` says.
#include <optional>

#include "engine/core/files.h"
#include "engine/image/display.h"
#include "engine/image/image.h"

namespace vamp {

// Errors of one set of channels: the colours of a layer, its alpha, or the components of a data layer.
struct ChannelErrors {
  std::string name;                   // "colour", "alpha", "depth", "light.alpha", ...
  std::vector<std::string> channels;  // full names
  double rmse = 0;                    // linear values: sqrt(mean((a - b)^2))
  double rel_mse = 0;                 // linear values: mean((a - b)^2 / (b^2 + 0.01)); b is the reference
  double max_error = 0;               // linear values: max |a - b|
  // Of the pictures as a display shows them (exposure, tone curve, sRGB encoding); colours only.
  std::optional<double> psnr;   // dB, peak 1, over R, G and B; nothing when they are equal
  std::optional<double> mssim;  // of the sRGB-encoded luminance; nothing when a side is under 11 pixels
  bool equal = false;           // every float is the same number
};

struct CompareReport {
  int width = 0;
  int height = 0;
  Display display;
  std::vector<ChannelErrors> sets;
  std::vector<std::string> only_in_a;  // channels that the other picture lacks
  std::vector<std::string> only_in_b;
};

// `a` against the reference `b`, over the channels that both have. Errors (bad_input): sizes differ, no common channel,
// values that are not finite. `file_a` and `file_b` are for messages.
Result<CompareReport> compare_images(const Image& a, const Image& b, const Display& display, std::string_view file_a,
                                     std::string_view file_b);

// Loads both and compares them. Two scene-linear files (OpenEXR, HDR) are shown through Khronos PBR Neutral, two
// display files (PNG, JPEG) as they are; one of each is an error, because the tone curve cannot be undone.
Result<CompareReport> compare_files(const fs::path& a, const fs::path& b, float exposure = 0);

// One JSON object, one value a line.
std::string compare_json(const CompareReport& report);
// A line for each set of channels, for people.
std::string compare_text(const CompareReport& report);

}  // namespace vamp
