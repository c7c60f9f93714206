#include "engine/scene/gltf_file.h"

#include <fmt/format.h>

#include <array>
#include <cstring>

namespace vamp {
namespace {

constexpr uint32_t kGlbMagic = 0x46546c67;  // "glTF"
constexpr uint32_t kJsonChunk = 0x4e4f534a;
constexpr uint32_t kBinChunk = 0x004e4942;
constexpr size_t kMaxBuffers = 10000;
// As a data: URI, base64 takes 4 bytes for 3.
constexpr size_t kMaxUri = kMaxModelBytes / 3 * 4 + 256;

uint32_t word_at(std::span<const std::byte> bytes, size_t offset) {
  std::array<uint8_t, 4> b;
  std::memcpy(b.data(), bytes.data() + offset, 4);
  return static_cast<uint32_t>(b[0]) | static_cast<uint32_t>(b[1]) << 8 | static_cast<uint32_t>(b[2]) << 16 |
         static_cast<uint32_t>(b[3]) << 24;
}

std::string_view text_of(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

struct Chunks {
  std::span<const std::byte> json;
  std::span<const std::byte> binary;
  bool has_binary = false;
};

// glTF 2.0, section 4.4 "Binary glTF Layout".
Result<Chunks> split_glb(std::span<const std::byte> bytes, const std::string& file) {
  const auto refuse = [&](const std::string& place, const std::string& expected, const std::string& found) {
    return fail(ErrorKind::bad_input, file, place, expected, found);
  };
  if (bytes.size() < 12) return refuse("header", "12 bytes", std::to_string(bytes.size()));
  if (word_at(bytes, 4) != 2) return refuse("header", "GLB version 2", std::to_string(word_at(bytes, 4)));
  const uint64_t length = word_at(bytes, 8);
  if (length > bytes.size() || length < 12)
    return refuse("header", fmt::format("{} bytes, as its length says", length), fmt::format("{}", bytes.size()));
  Chunks chunks;
  for (uint64_t at = 12; at < length;) {
    const std::string place = fmt::format("chunk at byte {}", at);
    if (length - at < 8) return refuse(place, "8 bytes of chunk header", std::to_string(length - at));
    const uint64_t size = word_at(bytes, at);
    const uint32_t type = word_at(bytes, at + 4);
    if (size > length - at - 8)
      return refuse(place, fmt::format("at most {} bytes", length - at - 8), std::to_string(size));
    const auto data = bytes.subspan(at + 8, size);
    if (at == 12 && type != kJsonChunk) return refuse(place, "a JSON chunk first", fmt::format("type {:#x}", type));
    if (at == 12) chunks.json = data;
    if (at != 12 && type == kBinChunk && !chunks.has_binary) {
      chunks.binary = data;
      chunks.has_binary = true;
    }
    at += 8 + size;
  }
  if (chunks.json.empty()) return refuse("header", "a JSON chunk", "nothing");
  return chunks;
}

Result<std::vector<std::byte>> decode_base64(std::string_view text, std::string_view file, std::string_view place) {
  const auto value = [](char c) -> int {
    if (c >= 'A' && c <= 'Z') return c - 'A';
    if (c >= 'a' && c <= 'z') return c - 'a' + 26;
    if (c >= '0' && c <= '9') return c - '0' + 52;
    return c == '+' ? 62 : c == '/' ? 63 : -1;
  };
  while (!text.empty() && text.back() == '=') text.remove_suffix(1);
  std::vector<std::byte> bytes;
  bytes.reserve(text.size() / 4 * 3 + 3);
  uint32_t bits = 0;
  int count = 0;
  for (size_t i = 0; i < text.size(); ++i) {
    const int v = value(text[i]);
    if (v < 0) return fail(ErrorKind::bad_input, file, place, "base64", fmt::format("a foreign character at {}", i));
    bits = bits << 6 | static_cast<uint32_t>(v);
    count += 6;
    if (count >= 8) {
      count -= 8;
      bytes.push_back(static_cast<std::byte>(bits >> count & 0xffu));
    }
  }
  if (count >= 6) return fail(ErrorKind::bad_input, file, place, "whole base64", "it breaks off");
  return bytes;
}

Status check_asset(const Json& json, const std::string& file) {
  if (!json.is_object()) return fail(ErrorKind::bad_input, file, "", "a JSON object", json.type_name());
  const JsonReader root(json, file);
  const JsonReader asset = root.member("asset");
  const std::string version = asset.member("version").text(16);
  const std::string least = asset.has("minVersion") ? asset.member("minVersion").text(16) : "2.0";
  VAMP_CHECK_STATUS(root.status());
  if (!version.starts_with("2.")) return fail(ErrorKind::bad_input, file, "asset.version", "glTF 2.x", version);
  if (least != "2.0") return fail(ErrorKind::bad_input, file, "asset.minVersion", "2.0", least);
  return {};
}

Status read_buffers(GltfFile& gltf, const Chunks& chunks) {
  const JsonReader root(gltf.json, gltf.file);
  if (!root.has("buffers")) return {};
  const JsonReader buffers = root.member("buffers");
  const size_t count = buffers.size(kMaxBuffers);
  VAMP_CHECK_STATUS(root.status());
  uint64_t total = 0;
  for (size_t i = 0; i < count; ++i) {
    const JsonReader buffer = buffers.element(i);
    const auto length = static_cast<uint64_t>(buffer.member("byteLength").integer(1, kMaxModelBytes));
    VAMP_CHECK_STATUS(root.status());
    std::span<const std::byte> bytes = chunks.binary;
    if (buffer.has("uri")) {
      const std::string uri = buffer.member("uri").text(kMaxUri);
      VAMP_CHECK_STATUS(root.status());
      VAMP_TRY(std::vector<std::byte> read, read_uri(uri, gltf.folder, gltf.file, buffer.path() + ".uri"));
      gltf.storage.push_back(std::move(read));
      bytes = gltf.storage.back();
    } else if (i != 0 || !chunks.has_binary) {
      return fail(ErrorKind::bad_input, gltf.file, buffer.path(), "a uri, or the BIN chunk of a .glb", "neither");
    }
    if (bytes.size() < length)
      return fail(ErrorKind::bad_input, gltf.file, buffer.path() + ".byteLength",
                  fmt::format("at most the {} bytes there are", bytes.size()), std::to_string(length));
    total += length;
    if (total > 2 * kMaxModelBytes)
      return fail(ErrorKind::bad_input, gltf.file, buffer.path(), "buffers of at most 2 GiB in all", "more");
    gltf.buffers.push_back(bytes.first(length));
  }
  return {};
}

}  // namespace

Result<std::string> percent_decoded(const std::string& uri, std::string_view file, std::string_view place) {
  std::string text;
  for (size_t i = 0; i < uri.size(); ++i) {
    if (uri[i] != '%') {
      text += uri[i];
      continue;
    }
    const auto digit = [&](size_t at) -> int {
      const char c = at < uri.size() ? uri[at] : ' ';
      if (c >= '0' && c <= '9') return c - '0';
      if (c >= 'a' && c <= 'f') return c - 'a' + 10;
      return c >= 'A' && c <= 'F' ? c - 'A' + 10 : -1;
    };
    if (digit(i + 1) < 0 || digit(i + 2) < 0)
      return fail(ErrorKind::bad_input, file, place, "two hexadecimal digits after %", "\"" + uri.substr(0, 80) + "\"");
    text += static_cast<char>(digit(i + 1) * 16 + digit(i + 2));
    i += 2;
  }
  return text;
}

Result<std::vector<std::byte>> read_uri(const std::string& uri, const fs::path& folder, std::string_view file,
                                        std::string_view place) {
  if (uri.starts_with("data:")) {
    const size_t comma = uri.find(',');
    const std::string_view head = std::string_view(uri).substr(0, comma);
    if (comma == std::string::npos || !head.ends_with(";base64"))
      return fail(ErrorKind::bad_input, file, place, "data in base64", std::string(head.substr(0, 60)));
    return decode_base64(std::string_view(uri).substr(comma + 1), file, place);
  }
  VAMP_TRY(const std::string name, percent_decoded(uri, file, place));
  VAMP_TRY(const fs::path path, resolve_inside(folder, name, file, place));
  std::error_code code;
  if (!fs::is_regular_file(path, code))
    return fail(ErrorKind::bad_input, file, place, "an existing file", "\"" + name.substr(0, 200) + "\"");
  return read_file(path, kMaxModelBytes);
}

Result<GltfFile> read_gltf_file(const fs::path& path) {
  GltfFile gltf;
  gltf.file = path.string();
  gltf.folder = path.parent_path();
  std::error_code code;
  if (fs::is_directory(path, code))
    return fail(ErrorKind::bad_input, gltf.file, "", "a .gltf or .glb file", "a folder");
  VAMP_TRY(std::vector<std::byte> bytes, read_file(path, kMaxModelBytes));
  gltf.storage.push_back(std::move(bytes));
  const std::span<const std::byte> whole = gltf.storage.front();

  Chunks chunks;
  if (whole.size() >= 4 && word_at(whole, 0) == kGlbMagic) {
    VAMP_TRY(chunks, split_glb(whole, gltf.file));
  } else {
    const size_t first = text_of(whole).find_first_not_of(" \t\r\n");
    if (first == std::string_view::npos || text_of(whole)[first] != '{')
      return fail(ErrorKind::bad_input, gltf.file, "", "a glTF model (.gltf or .glb)", "another kind of file");
    chunks.json = whole;
  }
  VAMP_TRY(gltf.json, parse_json(text_of(chunks.json), gltf.file, kMaxUri));
  VAMP_CHECK_STATUS(check_asset(gltf.json, gltf.file));
  VAMP_CHECK_STATUS(read_buffers(gltf, chunks));
  return gltf;
}

}  // namespace vamp
