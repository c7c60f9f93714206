#include "engine/btf/bdi.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "engine/btf/btf_checksum.h"
#include "engine/core/check.h"

namespace vamp {
namespace {

// Only this one is in use: the other two of the format, 0 (complete) and 1 (bzip2), are read by no public program.
constexpr uint8_t kSparseUncompressed = 2;
// Rows are put together up to this size, so that a reader that takes whole chunks gets by with little memory.
constexpr uint64_t kChunkBytes = uint64_t{64} << 20;
// Of the first value in a file of ours: a cache line.
constexpr size_t kAlignment = 64;

void check_chunks(Cursor& cursor, const BdiHeader& header) {
  for (uint64_t first = 0; first < header.stored_texels && cursor.status(); first += header.texels_per_chunk) {
    const uint64_t expected = std::min(header.texels_per_chunk, header.stored_texels - first) * header.bytes_per_texel;
    const uint64_t place = cursor.at();
    const auto size = cursor.number<uint32_t>("size of a chunk");
    if (cursor.status() && size != expected)
      cursor.refuse(place, "size of a chunk", std::to_string(expected), std::to_string(size));
    cursor.take(expected, "chunk");
  }
  if (cursor.left() > 0)
    cursor.refuse(cursor.at(), "end", "the end of the file", fmt::format("{} bytes", cursor.left()));
}

}  // namespace

Result<BdiHeader> read_bdi_header(std::span<const std::byte> bytes, std::string_view file) {
  Cursor cursor(bytes, file);
  BdiHeader header;
  VAMP_TRY(header.bonn, read_bonn_header(cursor));
  if (header.bonn.kind != BonnKind::bdi)
    return fail(ErrorKind::bad_input, file, "byte 0, signature", "!BDIF06R2!", header.bonn.signature);
  const BonnHeader& bonn = header.bonn;
  header.rows_per_chunk = cursor.count("rows per chunk", 1, bonn.height);
  const uint64_t place = cursor.at();
  if (const auto compression = cursor.number<uint8_t>("compression"); compression != kSparseUncompressed)
    cursor.refuse(place, "compression", "2 (sparse, uncompressed)", std::to_string(compression));
  header.mask = cursor.take(uint64_t{bonn.width} * bonn.height, "mask");
  header.rotation_count = cursor.number<uint32_t>("number of rotations");
  cursor.take(header.rotation_count * 9 * sizeof(float), "rotations");
  VAMP_CHECK_STATUS(cursor.status());
  VAMP_CHECK_STATUS(check_checksum(bytes.first(cursor.at()), header.bonn, file));
  header.stored_texels = header.mask.size() - static_cast<uint64_t>(std::ranges::count(header.mask, std::byte{0}));
  header.texels_per_chunk = uint64_t{header.rows_per_chunk} * bonn.width;
  header.bytes_per_texel = bonn.channels.size() * bonn.lights.size() * bonn.views.size() * sizeof(Half);
  header.first_texel = cursor.at() + sizeof(uint32_t);
  check_chunks(cursor, header);
  VAMP_CHECK_STATUS(cursor.status());
  return header;
}

std::optional<std::string> why_not_mapped(const BdiHeader& header) {
  if (header.bonn.channels.size() != 3) return fmt::format("{} spectral channels", header.bonn.channels.size());
  if (!header.bonn.has_cosine) return "values without the cosine of the light";
  if (header.stored_texels != header.mask.size())
    return fmt::format("{} texels left out", header.mask.size() - header.stored_texels);
  if (header.first_texel % sizeof(Half) != 0) return "values at odd bytes";
  return {};
}

namespace {

uint64_t bytes_per_row(const BtfInfo& info) { return info.values_per_texel() * sizeof(Half) * info.width; }

uint32_t rows_per_chunk(const BtfInfo& info) {
  return static_cast<uint32_t>(std::clamp<uint64_t>(kChunkBytes / bytes_per_row(info), 1, info.height));
}

// Everything in front of the first chunk.
std::vector<std::byte> header_of(const BtfInfo& info) {
  const size_t texels = info.texel_count();
  ByteWriter writer;
  const size_t behind_header = 3 * sizeof(uint32_t) + sizeof(uint8_t) + texels;
  BonnHeader header = bonn_header_of(info, BonnKind::bdi);
  write_bonn_header(writer, header, behind_header, kAlignment);
  writer.number(rows_per_chunk(info));
  writer.number(kSparseUncompressed);
  writer.bytes().resize(writer.size() + texels, std::byte{1});
  writer.number(uint32_t{0});  // rotations
  write_checksum(writer.bytes(), header);
  return std::move(writer.bytes());
}

}  // namespace

Result<Btf> Btf::create(const fs::path& path, BtfInfo info) {
  CHECK(info.in_range());
  const uint64_t row = bytes_per_row(info);
  if (row > std::numeric_limits<uint32_t>::max())
    return fail(ErrorKind::failed, path.string(), "", "rows of at most 4 GiB", fmt::format("{} bytes", row));
  const uint32_t rows = rows_per_chunk(info);
  const std::vector<std::byte> header = header_of(info);
  const uint64_t first_chunk = header.size();
  const uint64_t chunks = (info.height + uint64_t{rows} - 1) / rows;

  VAMP_TRY(MemoryMap map, MemoryMap::create(path, first_chunk + chunks * sizeof(uint32_t) + row * info.height));
  const auto bytes = map.writable();
  std::ranges::copy(header, bytes.begin());
  for (uint64_t chunk = 0; chunk < chunks; ++chunk) {
    const auto size = static_cast<uint32_t>(std::min<uint64_t>(rows, info.height - chunk * rows) * row);
    std::memcpy(bytes.data() + first_chunk + chunk * (sizeof(size) + row * rows), &size, sizeof(size));
  }
  const Layout layout{first_chunk + sizeof(uint32_t), uint64_t{rows} * info.width};
  return Btf(std::move(info), std::move(map), layout, path);
}

void Btf::set_provenance(std::string provenance) {
  info_.provenance = std::move(provenance);
  if (path_.empty()) return;
  const std::vector<std::byte> header = header_of(info_);
  CHECK(header.size() + sizeof(uint32_t) == layout_.first);
  std::ranges::copy(header, map_.writable().begin());
}

Result<Btf> Btf::open(const fs::path& path, MapAccess access) {
  VAMP_TRY(MemoryMap map, MemoryMap::open(path, access));
  VAMP_TRY(const BdiHeader header, read_bdi_header(map.bytes(), path.string()));
  if (const auto reason = why_not_mapped(header))
    return fail(ErrorKind::bad_input, path.string(), "", "a BDI file whose values can be used where they lie", *reason);
  const Layout layout{header.first_texel, header.texels_per_chunk};
  return Btf(info_of(header.bonn), std::move(map), layout, path);
}

}  // namespace vamp
