#pragma once
// Pictures from files and from memory: PNG, JPEG, OpenEXR and Radiance HDR, told apart by their first bytes, never by
// their names.
#include <cstdint>

#include "engine/core/files.h"
#include "engine/image/colour.h"
#include "engine/image/image.h"

namespace vamp {

enum class ImageFormat { png, jpeg, exr, hdr };

// PNG and JPEG hold what a display shows; OpenEXR and HDR hold scene-linear light.
constexpr bool is_display_format(ImageFormat format) {
  return format == ImageFormat::png || format == ImageFormat::jpeg;
}

struct ImageLimits {
  int side = 16384;                    // of width and height
  uint64_t bytes = uint64_t{1} << 30;  // of the decoded floats, and of the file
  size_t channels = 64;
};

// bad_input when the bytes are none of the four formats. `file` names them in messages.
Result<ImageFormat> image_format(std::span<const std::byte> bytes, std::string_view file);

// The first picture of the file in linear Rec.709. PNG and JPEG: channels Y, YA, RGB or RGBA, alpha not premultiplied,
// codes read as `space` says. OpenEXR: the data window, all channels, colours converted by the file's chromaticities.
// bad_input: another format, a damaged file, one over the limits, NaN or infinity (with the pixel's place). io: the
// file cannot be read.
Result<Image> load_image(const fs::path& path, ColourSpace space = ColourSpace::srgb, const ImageLimits& limits = {});
Result<Image> decode_image(std::span<const std::byte> bytes, std::string_view file,
                           ColourSpace space = ColourSpace::srgb, const ImageLimits& limits = {});

// What a file says of itself, without decoding its pixels; checked for damage as in load_image.
struct ImageInfo {
  ImageFormat format = ImageFormat::png;
  int width = 0;
  int height = 0;
  std::vector<std::string> channels;
  int bits = 0;  // per value: 8, 16 (also half), 32
};
Result<ImageInfo> image_info(std::span<const std::byte> bytes, std::string_view file, const ImageLimits& limits = {});

}  // namespace vamp
