#pragma once
// Pictures to files: PNG for what a display shows, OpenEXR for linear light and data layers.
#include <cstdint>

#include "engine/core/files.h"
#include "engine/image/colour.h"
#include "engine/image/image.h"
#include "engine/image/metadata.h"

namespace vamp {

struct PngOptions {
  int bits = 8;                           // per value: 8 or 16
  ColourSpace space = ColourSpace::srgb;  // srgb: encodes colours; linear: data as they are; alpha is always linear
  double dpi = 0;                         // pixels per inch; 0 leaves it out
  Metadata metadata;
};

struct ExrOptions {
  bool half = false;  // colours and alpha (R, G, B, A, Y) as half floats, cut off at 65504; other channels stay float
  Metadata metadata;
};

// Values in [0, 1], 1 to 4 channels (Y, YA, RGB, RGBA); below and above is cut off, codes are rounded to the nearest.
// No dither. A value that is not finite is an error (ErrorKind::failed) with its pixel's place.
Result<std::vector<std::byte>> encode_png(const Image& image, const PngOptions& options = {});

// 8-bit codes as they are: rows from the top, channels 1 to 4, codes.size() = width * height * channels.
Result<std::vector<std::byte>> encode_png_codes(int width, int height, int channels, std::span<const uint8_t> codes,
                                                const PngOptions& options = {});

// All channels, ZIP-compressed, with the chromaticities of Rec.709; metadata as string attributes of the same names.
Result<std::vector<std::byte>> encode_exr(const Image& image, const ExrOptions& options = {});

// Encode, then write atomically: the old file stays whole until the new one is complete. io when writing fails.
Status save_png(const fs::path& path, const Image& image, const PngOptions& options = {});
Status save_exr(const fs::path& path, const Image& image, const ExrOptions& options = {});

}  // namespace vamp
