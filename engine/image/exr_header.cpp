#include "engine/image/exr_header.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <utility>

namespace vamp {
namespace {

constexpr std::string_view kSignature("\x76\x2f\x31\x01", 4);
constexpr uint32_t kTiled = 0x200;
constexpr uint32_t kLongNames = 0x400;

// Reads forward through the header and remembers when the bytes ran out.
class Cursor {
 public:
  explicit Cursor(Bytes bytes, size_t at = 0) : bytes_(bytes), at_(at) {}

  bool failed() const { return failed_; }
  size_t at() const { return at_; }

  std::string_view name() {
    const std::string_view rest = as_text(bytes_).substr(std::min(at_, bytes_.size()));
    const size_t end = rest.substr(0, 256).find('\0');
    if (end == std::string_view::npos) failed_ = true;
    if (failed_) return {};
    at_ += end + 1;
    return rest.substr(0, end);
  }

  uint32_t number() {
    const Bytes four = take(4);
    return failed_ ? 0 : little_endian_32(four, 0);
  }

  Bytes take(size_t count) {
    if (count > bytes_.size() - std::min(at_, bytes_.size())) failed_ = true;
    if (failed_) return {};
    const Bytes taken = bytes_.subspan(at_, count);
    at_ += count;
    return taken;
  }

 private:
  Bytes bytes_;
  size_t at_;
  bool failed_ = false;
};

// What the header says, before it is judged.
struct Raw {
  ExrHeader header;
  std::optional<std::array<int64_t, 4>> window;  // first x, first y, last x, last y
  std::optional<std::array<uint32_t, 2>> tile;
  uint32_t compression = 0;
};

Status read_channels(Bytes data, std::string_view file, ExrHeader& header) {
  Cursor cursor(data);
  for (std::string_view name = cursor.name(); !name.empty(); name = cursor.name()) {
    const std::string place = fmt::format("channel {}", name);
    const uint32_t type = cursor.number();
    cursor.take(4);
    const uint32_t x_sampling = cursor.number();
    const uint32_t y_sampling = cursor.number();
    if (cursor.failed()) break;
    if (type != 1 && type != 2) return fail(ErrorKind::bad_input, file, place, "half or float values", "integers");
    if (x_sampling != 1 || y_sampling != 1)
      return fail(ErrorKind::bad_input, file, place, "a value for every pixel", "a subsampled channel");
    header.channels.emplace_back(name);
    header.is_half.push_back(type == 1);
  }
  if (cursor.failed() || cursor.at() != data.size())
    return fail(ErrorKind::bad_input, file, "channels", "a channel list", "a damaged one");
  return {};
}

// Bytes of types whose values decoders read by their own length, not by the attribute's: where the two differ, they and
// the check below would see different attributes after it.
constexpr std::pair<std::string_view, size_t> kLengths[] = {{"box2f", 16},
                                                            {"box2i", 16},
                                                            {"chromaticities", 32},
                                                            {"compression", 1},
                                                            {"deepImageState", 1},
                                                            {"double", 8},
                                                            {"envmap", 1},
                                                            {"float", 4},
                                                            {"int", 4},
                                                            {"keycode", 28},
                                                            {"lineOrder", 1},
                                                            {"m33d", 72},
                                                            {"m33f", 36},
                                                            {"m44d", 128},
                                                            {"m44f", 64},
                                                            {"rational", 8},
                                                            {"tiledesc", 9},
                                                            {"timecode", 8},
                                                            {"v2d", 16},
                                                            {"v2f", 8},
                                                            {"v2i", 8},
                                                            {"v3d", 24},
                                                            {"v3f", 12},
                                                            {"v3i", 12}};

// Whether a value is as long as its type or its own numbers say. A manifest of identifiers is unpacked into memory of
// a size that it names itself.
bool has_its_length(std::string_view type, Bytes data) {
  for (const auto& [name, length] : kLengths)
    if (type == name) return data.size() == length;
  if (type == "floatvector") return data.size() % 4 == 0;
  if (type == "preview")
    return data.size() >= 8 && data.size() % 4 == 0 &&
           uint64_t{little_endian_32(data, 0)} * little_endian_32(data, 4) == data.size() / 4 - 2;
  if (type == "idmanifest") return data.size() >= 4 && little_endian_32(data, 0) <= 1u << 26;
  if (type == "stringvector") {
    Cursor cursor(data);
    while (!cursor.failed() && cursor.at() < data.size()) cursor.take(cursor.number());
    return !cursor.failed();
  }
  return true;
}

Status read_attribute(std::string_view name, std::string_view type, Bytes data, std::string_view file, Raw& raw) {
  if (!has_its_length(type, data))
    return fail(ErrorKind::bad_input, file, name, fmt::format("an attribute as long as its {} is", type),
                fmt::format("{} bytes", data.size()));
  const auto signed_at = [data](size_t at) { return int64_t{std::bit_cast<int32_t>(little_endian_32(data, at))}; };
  if (type == "chlist") {
    if (name != "channels") return fail(ErrorKind::bad_input, file, name, "one list of channels", "another");
    return read_channels(data, file, raw.header);
  }
  if (name == "dataWindow" && type == "box2i" && data.size() == 16)
    raw.window = {signed_at(0), signed_at(4), signed_at(8), signed_at(12)};
  if (name == "compression" && data.size() == 1) raw.compression = std::to_integer<uint32_t>(data[0]);
  if (name == "tiles" && type == "tiledesc" && data.size() == 9)
    raw.tile = {little_endian_32(data, 0), little_endian_32(data, 4)};
  if (name == "chromaticities" && type == "chromaticities" && data.size() == 32) {
    raw.header.chromaticities.emplace();
    for (size_t i = 0; i < 8; ++i)
      (*raw.header.chromaticities)[i] = std::bit_cast<float>(little_endian_32(data, 4 * i));
  }
  if (type == "string") raw.header.texts[std::string(name)] = std::string(as_text(data));
  return {};
}

// The number of 8-byte offsets that follow the header; of the finest level alone where a file has several.
uint64_t chunk_count(const Raw& raw, bool tiled) {
  const auto parts = [](uint64_t length, uint64_t step) { return (length + step - 1) / step; };
  if (tiled) return parts(raw.header.width, (*raw.tile)[0]) * parts(raw.header.height, (*raw.tile)[1]);
  // Rows a chunk: none, RLE, ZIPS 1; ZIP, PXR24 16; PIZ, B44, B44A, DWAA 32; DWAB 256.
  constexpr std::array<uint64_t, 10> kRows = {1, 1, 1, 16, 32, 16, 32, 32, 32, 256};
  return parts(raw.header.height, kRows[raw.compression]);
}

}  // namespace

bool is_exr(Bytes bytes) { return as_text(bytes).starts_with(kSignature); }

Result<ExrHeader> check_exr(Bytes bytes, std::string_view file) {
  const auto refuse = [file](std::string_view place, std::string_view expected, std::string_view found) {
    return fail(ErrorKind::bad_input, file, place, expected, found);
  };
  if (!is_exr(bytes)) return refuse("", "an OpenEXR file", "another signature");
  Cursor cursor(bytes, kSignature.size());
  const uint32_t version = cursor.number();
  if (cursor.failed() || (version & 0xff) != 2) return refuse("byte 4", "OpenEXR version 2", "another version");
  if ((version & ~(0xffu | kTiled | kLongNames)) != 0)
    return refuse("byte 4", "a flat picture in one part", "a deep or multi-part file");

  Raw raw;
  for (std::string_view name = cursor.name(); !name.empty(); name = cursor.name()) {
    const std::string_view type = cursor.name();
    const uint32_t size = cursor.number();
    const Bytes data = cursor.take(size);
    if (cursor.failed()) break;
    VAMP_CHECK_STATUS(read_attribute(name, type, data, file, raw));
  }
  if (cursor.failed()) return refuse(fmt::format("byte {}", cursor.at()), "an OpenEXR attribute", "damaged bytes");
  if (raw.header.channels.empty()) return refuse("channels", "at least one channel", "none");
  if (raw.compression > 9) return refuse("compression", "a known method", std::to_string(raw.compression));
  if (!raw.window) return refuse("dataWindow", "a box", "nothing");
  const auto [x0, y0, x1, y1] = *raw.window;
  if (x1 < x0 || y1 < y0 || x1 - x0 >= INT32_MAX || y1 - y0 >= INT32_MAX)
    return refuse("dataWindow", "a box with its first corner before its last",
                  fmt::format("{} {} {} {}", x0, y0, x1, y1));
  raw.header.width = static_cast<uint32_t>(x1 - x0 + 1);
  raw.header.height = static_cast<uint32_t>(y1 - y0 + 1);
  const bool tiled = (version & kTiled) != 0;
  if (tiled && (!raw.tile || (*raw.tile)[0] == 0 || (*raw.tile)[1] == 0))
    return refuse("tiles", "a tile size", "nothing or 0");
  if (chunk_count(raw, tiled) > (bytes.size() - cursor.at()) / 8)
    return refuse("chunk table", fmt::format("{} offsets", chunk_count(raw, tiled)), "the end of the file");
  return std::move(raw.header);
}

}  // namespace vamp
