#include "engine/image/save.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/core/check.h"
#include "engine/core/half.h"
#include "engine/image/png_chunks.h"
#include "shaders/shared/tonemap.h"

namespace vamp {
namespace {

// Of zlib, 0 to 9.
constexpr int kPngCompression = 3;

Status check_finite(const Image& image) {
  if (const auto bad = first_not_finite(image))
    return fail(ErrorKind::failed, "", bad->first, "a finite number to save", bad->second);
  return {};
}

// Runs one of OpenImageIO's encoders into memory.
Result<std::vector<std::byte>> encode(const char* plugin, OIIO::ImageSpec spec, OIIO::TypeDesc type,
                                      const void* pixels) {
  const auto failed = [plugin](const std::string& why) {
    return fail(ErrorKind::failed, "", "", fmt::format("the {} encoder failed: {}", plugin, why));
  };
  try {
    std::vector<unsigned char> out;
    OIIO::Filesystem::IOVecOutput writer(out);
    OIIO::Filesystem::IOProxy* proxy = &writer;
    spec.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);
    const auto output = OIIO::ImageOutput::create(plugin);
    if (!output) return failed("it is not installed");
    if (!output->open(fmt::format("memory.{}", plugin), spec) || !output->write_image(type, pixels) || !output->close())
      return failed(output->geterror());
    const auto bytes = std::as_bytes(std::span(out));
    return std::vector<std::byte>(bytes.begin(), bytes.end());
  } catch (const std::exception& error) {
    return failed(error.what());
  }
}

Result<std::vector<std::byte>> encode_codes(int width, int height, int channels, OIIO::TypeDesc type, const void* codes,
                                            const PngOptions& options) {
  OIIO::ImageSpec spec(width, height, channels, type);
  spec.attribute("png:compressionLevel", kPngCompression);
  spec.attribute("oiio:UnassociatedAlpha", 1);
  if (options.space == ColourSpace::srgb) spec.attribute("oiio:ColorSpace", "sRGB");
  VAMP_TRY(const auto bytes, encode("png", std::move(spec), type, codes));
  return png_with_texts(bytes, options.metadata, options.dpi);
}

template <class Code>
std::vector<Code> codes_of(const Image& image, ColourSpace space) {
  constexpr auto kTop = static_cast<float>(std::numeric_limits<Code>::max());
  const size_t wide = image.channels.size();
  const size_t colours = wide == 2 || wide == 4 ? wide - 1 : wide;
  std::vector<Code> codes(image.pixels.size());
  for (size_t i = 0; i < codes.size(); ++i) {
    const float v = image.pixels[i];
    const bool encoded = space == ColourSpace::srgb && i % wide < colours;
    const float unit = encoded ? srgb_encode(v) : std::clamp(v, 0.0f, 1.0f);
    codes[i] = static_cast<Code>(unit * kTop + 0.5f);
  }
  return codes;
}

bool is_colour_channel(std::string_view name) {
  const std::string_view component = component_of(name);
  return component == "R" || component == "G" || component == "B" || component == "A" || component == "Y";
}

}  // namespace

Result<std::vector<std::byte>> encode_png(const Image& image, const PngOptions& options) {
  CHECK(options.bits == 8 || options.bits == 16);
  CHECK(image.channels.size() <= 4);
  VAMP_CHECK_STATUS(check_finite(image));
  const auto channels = static_cast<int>(image.channels.size());
  if (options.bits == 8)
    return encode_png_codes(image.width, image.height, channels, codes_of<uint8_t>(image, options.space), options);
  const auto codes = codes_of<uint16_t>(image, options.space);
  return encode_codes(image.width, image.height, channels, OIIO::TypeDesc::UINT16, codes.data(), options);
}

Result<std::vector<std::byte>> encode_png_codes(int width, int height, int channels, std::span<const uint8_t> codes,
                                                const PngOptions& options) {
  CHECK(width > 0 && height > 0 && channels >= 1 && channels <= 4);
  CHECK(codes.size() == static_cast<size_t>(width) * static_cast<size_t>(height) * static_cast<size_t>(channels));
  return encode_codes(width, height, channels, OIIO::TypeDesc::UINT8, codes.data(), options);
}

Result<std::vector<std::byte>> encode_exr(const Image& image, const ExrOptions& options) {
  VAMP_CHECK_STATUS(check_finite(image));
  OIIO::ImageSpec spec(image.width, image.height, static_cast<int>(image.channels.size()), OIIO::TypeDesc::FLOAT);
  spec.channelnames = image.channels;
  spec.alpha_channel = -1;
  std::vector<bool> is_half(image.channels.size());
  for (size_t c = 0; c < is_half.size(); ++c) {
    is_half[c] = options.half && is_colour_channel(image.channels[c]);
    spec.channelformats.push_back(is_half[c] ? OIIO::TypeDesc::HALF : OIIO::TypeDesc::FLOAT);
  }
  spec.attribute("compression", "zip");
  spec.attribute("chromaticities", OIIO::TypeDesc(OIIO::TypeDesc::FLOAT, 8), kRec709.data());
  // Without it OpenImageIO writes the time of day, and the same picture would not be the same file.
  spec.attribute("DateTime", "");
  for (const auto& [key, value] : options.metadata) {
    CHECK(!key.empty());
    std::string text = value;
    std::erase(text, '\0');
    spec.attribute(key == "capDate" ? "DateTime" : key, text);
  }
  if (!options.half) return encode("openexr", std::move(spec), OIIO::TypeDesc::FLOAT, image.pixels.data());
  std::vector<float> pixels = image.pixels;
  for (size_t i = 0; i < pixels.size(); ++i)
    if (is_half[i % is_half.size()]) pixels[i] = std::clamp(pixels[i], -kHalfMax, kHalfMax);
  return encode("openexr", std::move(spec), OIIO::TypeDesc::FLOAT, pixels.data());
}

Status save_png(const fs::path& path, const Image& image, const PngOptions& options) {
  auto bytes = encode_png(image, options);
  if (!bytes) {
    bytes.error().file = path.string();
    return tl::unexpected(std::move(bytes).error());
  }
  return write_file_atomically(path, *bytes);
}

Status save_exr(const fs::path& path, const Image& image, const ExrOptions& options) {
  auto bytes = encode_exr(image, options);
  if (!bytes) {
    bytes.error().file = path.string();
    return tl::unexpected(std::move(bytes).error());
  }
  return write_file_atomically(path, *bytes);
}

}  // namespace vamp
