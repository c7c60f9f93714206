#include "engine/image/load.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/image/bytes.h"
#include "engine/image/exr_header.h"
#include "engine/image/jpeg.h"
#include "engine/image/png_chunks.h"

namespace vamp {
namespace {

constexpr const char* kPlugin[] = {"png", "jpeg", "openexr", "hdr"};
constexpr const char* kFormatName[] = {"PNG", "JPEG", "OpenEXR", "Radiance HDR"};

bool is_hdr(Bytes bytes) {
  return as_text(bytes).starts_with("#?RADIANCE\n") || as_text(bytes).starts_with("#?RGBE\n");
}

// The header must say RGBE pixels (not XYZE), rows from the top and columns from the left.
Status check_hdr(Bytes bytes, std::string_view file) {
  const std::string_view header = as_text(bytes.first(std::min<size_t>(bytes.size(), 1 << 16)));
  const size_t blank = header.find("\n\n");
  if (blank == std::string_view::npos)
    return fail(ErrorKind::bad_input, file, "header", "a blank line at its end", "none");
  if (header.substr(0, blank).find("FORMAT=32-bit_rle_rgbe") == std::string_view::npos)
    return fail(ErrorKind::bad_input, file, "header", "FORMAT=32-bit_rle_rgbe", "another pixel format");
  const std::string_view size = header.substr(blank + 2, 64);
  if (!size.starts_with("-Y ") || size.find(" +X ") == std::string_view::npos)
    return fail(ErrorKind::bad_input, file, "header", "a size as -Y height +X width", "another orientation");
  return {};
}

Status check_limits(uint64_t width, uint64_t height, uint64_t channels, std::string_view file,
                    const ImageLimits& limits) {
  const auto side = static_cast<uint64_t>(limits.side);
  if (width == 0 || height == 0 || width > side || height > side)
    return fail(ErrorKind::bad_input, file, "size", fmt::format("from 1 x 1 to {0} x {0} pixels", side),
                fmt::format("{} x {}", width, height));
  if (channels == 0 || channels > limits.channels)
    return fail(ErrorKind::bad_input, file, "channels", fmt::format("from 1 to {}", limits.channels),
                std::to_string(channels));
  if (width * height * channels * sizeof(float) > limits.bytes)
    return fail(ErrorKind::bad_input, file, "size", fmt::format("at most {} MiB of pixels", limits.bytes >> 20),
                fmt::format("{} x {} pixels with {} channels", width, height, channels));
  return {};
}

// Looks through the structure of the file before a decoder does.
Status check_structure(Bytes bytes, ImageFormat format, std::string_view file, const ImageLimits& limits) {
  switch (format) {
    case ImageFormat::png: {
      VAMP_TRY(const PngHeader header, check_png(bytes, file));
      return check_limits(header.width, header.height, 1, file, limits);
    }
    case ImageFormat::jpeg: {
      VAMP_TRY(const JpegHeader header, check_jpeg(bytes, file));
      return check_limits(header.width, header.height, 1, file, limits);
    }
    case ImageFormat::exr: {
      VAMP_TRY(const ExrHeader header, check_exr(bytes, file));
      return check_limits(header.width, header.height, header.channels.size(), file, limits);
    }
    case ImageFormat::hdr:
      return check_hdr(bytes, file);
  }
  return {};
}

std::vector<std::string> integer_channels(size_t count) {
  static const std::vector<std::string> names[] = {{"Y"}, {"Y", "A"}, {"R", "G", "B"}, {"R", "G", "B", "A"}};
  return names[std::clamp<size_t>(count, 1, 4) - 1];
}

// An opened decoder over bytes in memory; the format is known, so that no other plugin may try its luck.
struct Decoder {
  OIIO::Filesystem::IOMemReader reader;
  std::unique_ptr<OIIO::ImageInput> input;
  OIIO::ImageSpec spec;

  explicit Decoder(Bytes bytes) : reader(const_cast<std::byte*>(bytes.data()), bytes.size()) {}

  Status open(ImageFormat format, std::string_view file, const ImageLimits& limits) {
    const auto kind = static_cast<size_t>(format);
    input = OIIO::ImageInput::create(kPlugin[kind]);
    if (!input)
      return fail(ErrorKind::failed, file, "", fmt::format("no decoder for {} is installed", kFormatName[kind]));
    OIIO::ImageSpec config;
    OIIO::Filesystem::IOProxy* proxy = &reader;
    config.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &proxy);
    config.attribute("oiio:UnassociatedAlpha", 1);
    if (!input->open(fmt::format("memory.{}", kPlugin[kind]), spec, config)) return damaged(format, file);
    return check_limits(static_cast<uint64_t>(std::max(spec.width, 0)), static_cast<uint64_t>(std::max(spec.height, 0)),
                        static_cast<uint64_t>(std::max(spec.nchannels, 0)), file, limits);
  }

  tl::unexpected<Error> damaged(ImageFormat format, std::string_view file) const {
    std::string why = input->geterror();
    std::replace(why.begin(), why.end(), '\n', ' ');
    return fail(ErrorKind::bad_input, file, "",
                fmt::format("a sound {} file", kFormatName[static_cast<size_t>(format)]),
                why.empty() ? "damaged pixels" : why);
  }

  bool read(OIIO::TypeDesc type, void* pixels) { return input->read_image(0, 0, 0, spec.nchannels, type, pixels); }
};

template <class Code>
Status read_codes(Decoder& decoder, ImageFormat format, std::string_view file, ColourSpace space, Image& image) {
  std::vector<Code> codes(image.pixels.size());
  if (!decoder.read(OIIO::BaseTypeFromC<Code>::value, codes.data())) return decoder.damaged(format, file);
  const size_t count = size_t{std::numeric_limits<Code>::max()} + 1;
  const std::vector<float> colour = decoding_table(count, space);
  const std::vector<float> plain = decoding_table(count, ColourSpace::linear);
  const size_t wide = image.channels.size();
  for (size_t c = 0; c < wide; ++c) {
    const auto& table = image.channels[c] == "A" ? plain : colour;
    for (size_t i = c; i < codes.size(); i += wide) image.pixels[i] = table[codes[i]];
  }
  return {};
}

// Converts every layer with R, G and B.
Status convert_to_rec709(Image& image, const std::array<float, 8>& chromaticities, std::string_view file) {
  const auto same = [](float a, float b) { return std::abs(a - b) < 1e-4f; };
  if (std::equal(chromaticities.begin(), chromaticities.end(), kRec709.begin(), same)) return {};
  std::array<double, 9> m{};
  if (!matrix_to_rec709(chromaticities, m))
    return fail(ErrorKind::bad_input, file, "chromaticities", "three primaries and a white that span a colour space",
                fmt::format("{}", fmt::join(chromaticities, " ")));
  for (size_t r = 0; r < image.channels.size(); ++r) {
    if (component_of(image.channels[r]) != "R") continue;
    std::string name = image.channels[r];
    name.back() = 'G';
    const auto g = image.channel(name);
    name.back() = 'B';
    const auto b = image.channel(name);
    if (!g || !b) continue;
    for (size_t at = 0; at < image.pixels.size(); at += image.channels.size()) {
      float* pixel = image.pixels.data() + at;
      const double rgb[] = {pixel[r], pixel[*g], pixel[*b]};
      const auto row = [&](size_t i) {
        return static_cast<float>(m[i] * rgb[0] + m[i + 1] * rgb[1] + m[i + 2] * rgb[2]);
      };
      pixel[r] = row(0);
      pixel[*g] = row(3);
      pixel[*b] = row(6);
    }
  }
  return {};
}

Result<Image> decode(Bytes bytes, std::string_view file, ColourSpace space, const ImageLimits& limits) {
  VAMP_TRY(const ImageFormat format, image_format(bytes, file));
  VAMP_CHECK_STATUS(check_structure(bytes, format, file, limits));
  Decoder decoder(bytes);
  VAMP_CHECK_STATUS(decoder.open(format, file, limits));
  const auto& spec = decoder.spec;
  const auto count = static_cast<size_t>(spec.nchannels);
  const bool named = format == ImageFormat::exr && spec.channelnames.size() == count;
  if (!named && count > 4) return fail(ErrorKind::bad_input, file, "channels", "at most 4", std::to_string(count));
  Image image(spec.width, spec.height, named ? spec.channelnames : integer_channels(count));
  if (is_display_format(format)) {
    const bool wide = spec.format.basesize() > 1;
    VAMP_CHECK_STATUS(wide ? read_codes<uint16_t>(decoder, format, file, space, image)
                           : read_codes<uint8_t>(decoder, format, file, space, image));
    return image;
  }
  if (!decoder.read(OIIO::TypeDesc::FLOAT, image.pixels.data())) return decoder.damaged(format, file);
  if (const auto bad = first_not_finite(image))
    return fail(ErrorKind::bad_input, file, bad->first, "finite numbers", bad->second);
  if (format == ImageFormat::exr) {
    VAMP_TRY(const ExrHeader header, check_exr(bytes, file));
    if (header.chromaticities) VAMP_CHECK_STATUS(convert_to_rec709(image, *header.chromaticities, file));
  }
  return image;
}

}  // namespace

Result<ImageFormat> image_format(Bytes bytes, std::string_view file) {
  if (is_png(bytes)) return ImageFormat::png;
  if (is_jpeg(bytes)) return ImageFormat::jpeg;
  if (is_exr(bytes)) return ImageFormat::exr;
  if (is_hdr(bytes)) return ImageFormat::hdr;
  return fail(ErrorKind::bad_input, file, "", "a PNG, JPEG, OpenEXR or Radiance HDR picture",
              bytes.empty() ? "an empty file" : "another kind of file");
}

Result<Image> decode_image(Bytes bytes, std::string_view file, ColourSpace space, const ImageLimits& limits) {
  // The libraries throw on what they do not expect; for us that is one more damaged file.
  try {
    return decode(bytes, file, space, limits);
  } catch (const std::exception& error) {
    return fail(ErrorKind::bad_input, file, "", "a sound picture", error.what());
  }
}

Result<Image> load_image(const fs::path& path, ColourSpace space, const ImageLimits& limits) {
  VAMP_TRY(const auto bytes, read_file(path, limits.bytes));
  return decode_image(bytes, path.string(), space, limits);
}

Result<ImageInfo> image_info(Bytes bytes, std::string_view file, const ImageLimits& limits) {
  try {
    VAMP_TRY(const ImageFormat format, image_format(bytes, file));
    VAMP_CHECK_STATUS(check_structure(bytes, format, file, limits));
    Decoder decoder(bytes);
    VAMP_CHECK_STATUS(decoder.open(format, file, limits));
    const auto& spec = decoder.spec;
    const auto channels =
        format == ImageFormat::exr ? spec.channelnames : integer_channels(static_cast<size_t>(spec.nchannels));
    return ImageInfo{format, spec.width, spec.height, channels, static_cast<int>(spec.format.basesize()) * 8};
  } catch (const std::exception& error) {
    return fail(ErrorKind::bad_input, file, "", "a sound picture", error.what());
  }
}

}  // namespace vamp
