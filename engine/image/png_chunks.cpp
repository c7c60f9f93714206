#include "engine/image/png_chunks.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "engine/core/check.h"

namespace vamp {
namespace {

constexpr std::string_view kSignature = "\x89PNG\r\n\x1a\n";
constexpr size_t kInflatedLimit = size_t{16} << 20;  // of one compressed text

struct Chunk {
  std::string_view type;
  Bytes data;
  size_t offset;  // of its length field in the file
};

uint32_t checksum_of(Bytes type_and_data) {
  return static_cast<uint32_t>(crc32_z(0, reinterpret_cast<const Bytef*>(type_and_data.data()), type_and_data.size()));
}

// Calls visit(chunk) for each chunk, which says whether to go on.
template <class Visitor>
Status walk(Bytes bytes, std::string_view file, const Visitor& visit) {
  if (!is_png(bytes)) return fail(ErrorKind::bad_input, file, "", "a PNG file", "another signature");
  for (size_t at = kSignature.size(); at < bytes.size();) {
    const auto place = [at] { return fmt::format("byte {}", at); };
    if (bytes.size() - at < 12) return fail(ErrorKind::bad_input, file, place(), "a PNG chunk", "the end of the file");
    const uint32_t length = big_endian_32(bytes, at);
    if (length > bytes.size() - at - 12)
      return fail(ErrorKind::bad_input, file, place(), fmt::format("a PNG chunk of {} bytes", length),
                  "the end of the file");
    const Bytes type_and_data = bytes.subspan(at + 4, size_t{4} + length);
    if (checksum_of(type_and_data) != big_endian_32(bytes, at + 8 + length))
      return fail(ErrorKind::bad_input, file, place(), "a PNG chunk with the right checksum", "a damaged one");
    const Chunk chunk{as_text(type_and_data.first(4)), type_and_data.subspan(4), at};
    if (!visit(chunk)) return {};
    at += size_t{12} + length;
    if (chunk.type == "IEND") return {};
  }
  return fail(ErrorKind::bad_input, file, "", "a PNG file that ends in an IEND chunk", "the end of the file");
}

std::string inflated(Bytes compressed) {
  z_stream stream{};
  if (inflateInit(&stream) != Z_OK) return {};
  stream.next_in = const_cast<Bytef*>(reinterpret_cast<const Bytef*>(compressed.data()));
  stream.avail_in = static_cast<uInt>(compressed.size());
  std::string text;
  int state = Z_OK;
  while (state == Z_OK && text.size() < kInflatedLimit) {
    char piece[1 << 14];
    stream.next_out = reinterpret_cast<Bytef*>(piece);
    stream.avail_out = sizeof(piece);
    state = inflate(&stream, Z_NO_FLUSH);
    text.append(piece, sizeof(piece) - stream.avail_out);
  }
  inflateEnd(&stream);
  return state == Z_STREAM_END ? text : std::string();
}

std::string utf8_from_latin1(std::string_view latin1) {
  std::string text;
  for (const char c : latin1) {
    const auto code = static_cast<unsigned char>(c);
    if (code >= 0x80) text += static_cast<char>(0xc0 | code >> 6);
    text += code < 0x80 ? c : static_cast<char>(0x80 | (code & 0x3f));
  }
  return text;
}

// Takes the text up to the next zero byte off the front of `rest`.
std::optional<std::string_view> cut_field(std::string_view& rest) {
  const size_t end = rest.find('\0');
  if (end == std::string_view::npos) return std::nullopt;
  const std::string_view field = rest.substr(0, end);
  rest.remove_prefix(end + 1);
  return field;
}

// Adds the text of a tEXt, zTXt or iTXt chunk; damaged ones are passed over, as decoders do.
void take_text(const Chunk& chunk, Metadata& texts) {
  std::string_view rest = as_text(chunk.data);
  const auto compressed = [&rest] { return Bytes(reinterpret_cast<const std::byte*>(rest.data()), rest.size()); };
  const auto key = cut_field(rest);
  if (!key || key->empty()) return;
  const std::string name = utf8_from_latin1(*key);
  if (chunk.type == "tEXt") {
    texts[name] = utf8_from_latin1(rest);
  } else if (chunk.type == "zTXt" && rest.size() > 1 && rest[0] == 0) {
    rest.remove_prefix(1);
    texts[name] = utf8_from_latin1(inflated(compressed()));
  } else if (chunk.type == "iTXt" && rest.size() >= 4) {
    const bool is_compressed = rest[0] == 1;
    rest.remove_prefix(2);
    if (!cut_field(rest) || !cut_field(rest)) return;  // language, translated keyword
    texts[name] = is_compressed ? inflated(compressed()) : std::string(rest);
  }
}

void append_32(std::vector<std::byte>& out, uint32_t value) {
  for (int shift = 24; shift >= 0; shift -= 8) out.push_back(static_cast<std::byte>(value >> shift & 0xff));
}

void append_text(std::vector<std::byte>& out, std::string_view text) {
  const auto bytes = std::as_bytes(std::span(text.data(), text.size()));
  out.insert(out.end(), bytes.begin(), bytes.end());
}

void append_chunk(std::vector<std::byte>& out, std::string_view type, std::string_view data) {
  append_32(out, static_cast<uint32_t>(data.size()));
  const size_t start = out.size();
  append_text(out, type);
  append_text(out, data);
  append_32(out, checksum_of(Bytes(out).subspan(start)));
}

bool fits_png_key(std::string_view key) {
  const auto printable = [](char c) { return c >= ' ' && c <= '~'; };
  return !key.empty() && key.size() <= 79 && key.front() != ' ' && key.back() != ' ' &&
         key.find("  ") == std::string_view::npos && std::all_of(key.begin(), key.end(), printable);
}

}  // namespace

bool is_png(Bytes bytes) { return as_text(bytes).starts_with(kSignature); }

Result<PngHeader> check_png(Bytes bytes, std::string_view file) {
  PngHeader header;
  bool first = true;
  bool header_fits = false;
  bool pixels_seen = false;
  VAMP_CHECK_STATUS(walk(bytes, file, [&](const Chunk& chunk) {
    if (first && chunk.type == "IHDR" && chunk.data.size() == 13) {
      header_fits = true;
      header = {big_endian_32(chunk.data, 0), big_endian_32(chunk.data, 4), std::to_integer<int>(chunk.data[8]),
                std::to_integer<int>(chunk.data[9])};
    }
    first = false;
    pixels_seen = pixels_seen || chunk.type == "IDAT";
    return header_fits;
  }));
  if (!header_fits) return fail(ErrorKind::bad_input, file, "byte 8", "a PNG header (IHDR)", "another chunk");
  if (!pixels_seen) return fail(ErrorKind::bad_input, file, "", "a PNG file with pixels (IDAT)", "none");
  return header;
}

Result<Metadata> png_texts(Bytes bytes, std::string_view file) {
  Metadata texts;
  VAMP_CHECK_STATUS(walk(bytes, file, [&texts](const Chunk& chunk) {
    take_text(chunk, texts);
    return true;
  }));
  return texts;
}

std::vector<std::byte> png_with_texts(Bytes png, const Metadata& texts, double dpi) {
  constexpr size_t kAfterHeader = 8 + 12 + 13;
  CHECK(is_png(png) && png.size() > kAfterHeader);
  std::vector<std::byte> out(png.begin(), png.begin() + kAfterHeader);
  if (dpi > 0) {
    std::vector<std::byte> data;
    for (int axis = 0; axis < 2; ++axis) append_32(data, static_cast<uint32_t>(std::lround(dpi / 0.0254)));
    data.push_back(std::byte{1});  // the unit is the metre
    append_chunk(out, "pHYs", as_text(data));
  }
  for (const auto& [key, value] : texts) {
    CHECK(fits_png_key(key));
    std::string text = value;
    std::erase(text, '\0');
    const bool ascii =
        std::all_of(text.begin(), text.end(), [](char c) { return static_cast<unsigned char>(c) < 0x80; });
    // After the keyword iTXt has: not compressed, method 0, no language, no translated keyword.
    if (ascii)
      append_chunk(out, "tEXt", key + '\0' + text);
    else
      append_chunk(out, "iTXt", key + std::string(5, '\0') + text);
  }
  out.insert(out.end(), png.begin() + kAfterHeader, png.end());
  return out;
}

}  // namespace vamp
