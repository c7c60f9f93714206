#include "engine/material/preset_tables.h"

#include <fmt/format.h>

#include <array>
#include <bit>
#include <cstring>

#include "engine/core/check.h"
#include "engine/core/hash.h"

namespace vamp {
namespace {

static_assert(std::endian::native == std::endian::little, "tables are written as they lie in memory");

constexpr char kMagic[9] = "VAMPTABL";
constexpr uint32_t kVersion = 1;

struct Header {
  char magic[8];
  uint32_t version, sections;
  uint64_t size, checksum;
};
struct Section {
  char name[16];
  uint32_t dtype, unused;
  uint64_t offset, bytes, checksum;
};
static_assert(sizeof(Header) == 32 && sizeof(Section) == 48);

enum : uint32_t { kU32 = 1, kF32 = 2, kF16 = 3 };

struct Want {
  const char* name;
  uint32_t dtype;
  uint64_t bytes;
};
using Layout = std::array<Want, 4>;

Layout layout(uint64_t texels, uint64_t entries, uint64_t directions, uint64_t records) {
  return {{{"texels", kU32, texels * sizeof(tables::Texel)},
           {"entries", kU32, entries * sizeof(tables::Entry)},
           {"directions", kF32, directions * sizeof(vec3)},
           {"residual", kF16, records * sizeof(tables::ResidualRecord)}}};
}

constexpr uint64_t aligned(uint64_t offset) { return (offset + 15) & ~uint64_t{15}; }

}  // namespace

uint64_t tables_size(size_t texels, size_t entries, size_t directions, size_t records) {
  uint64_t size = sizeof(Header) + 4 * sizeof(Section);
  for (const Want& want : layout(texels, entries, directions, records)) size = aligned(size) + want.bytes;
  return size;
}

std::vector<std::byte> encode_tables(const Spmm& spmm) {
  const Residual& residual = spmm.residual;
  // Directions without records are no residual.
  const size_t directions = residual.records.empty() ? 0 : residual.directions.size();
  const Layout wants = layout(spmm.texels.size(), spmm.entries.size(), directions, residual.records.size());
  const std::array<const void*, 4> sources = {spmm.texels.data(), spmm.entries.data(), residual.directions.data(),
                                              residual.records.data()};
  std::vector<std::byte> bytes(
      tables_size(spmm.texels.size(), spmm.entries.size(), directions, residual.records.size()));
  std::array<Section, 4> sections{};
  uint64_t offset = sizeof(Header) + sizeof(sections);
  for (size_t i = 0; i < wants.size(); ++i) {
    offset = aligned(offset);
    if (wants[i].bytes > 0) std::memcpy(bytes.data() + offset, sources[i], wants[i].bytes);
    std::strncpy(sections[i].name, wants[i].name, sizeof(sections[i].name) - 1);
    sections[i].dtype = wants[i].dtype;
    sections[i].offset = offset;
    sections[i].bytes = wants[i].bytes;
    sections[i].checksum = hash64(std::span(bytes).subspan(offset, wants[i].bytes));
    offset += wants[i].bytes;
  }
  Header header{{}, kVersion, 4, bytes.size(), hash64(std::as_bytes(std::span(sections)))};
  std::memcpy(header.magic, kMagic, sizeof(header.magic));
  std::memcpy(bytes.data(), &header, sizeof(header));
  std::memcpy(bytes.data() + sizeof(header), sections.data(), sizeof(sections));
  return bytes;
}

Status decode_tables(std::span<const std::byte> bytes, std::string_view file, size_t entries, size_t directions,
                     Spmm& spmm) {
  const auto refuse = [&](std::string_view place, std::string_view expected, const std::string& found) {
    return fail(ErrorKind::bad_input, file, place, expected, found);
  };
  Header header;
  std::array<Section, 4> sections;
  if (bytes.size() < sizeof(header) + sizeof(sections))
    return refuse("", "a table file of a preset", fmt::format("{} bytes", bytes.size()));
  std::memcpy(&header, bytes.data(), sizeof(header));
  std::memcpy(sections.data(), bytes.data() + sizeof(header), sizeof(sections));
  if (std::memcmp(header.magic, kMagic, sizeof(header.magic)) != 0)
    return refuse("magic", "a table file of a preset (VAMPTABL)", "something else");
  if (header.version != kVersion) return refuse("version", std::to_string(kVersion), std::to_string(header.version));
  if (header.size != bytes.size())
    return refuse("size", fmt::format("{} bytes", header.size), fmt::format("{} (truncated or damaged)", bytes.size()));
  if (header.sections != sections.size())
    return refuse("section count", std::to_string(sections.size()), std::to_string(header.sections));
  if (header.checksum != hash64(std::as_bytes(std::span(sections))))
    return refuse("section table", "its checksum", "other bytes (damaged)");

  const size_t texels = static_cast<size_t>(spmm.width) * static_cast<size_t>(spmm.height);
  const size_t records = spmm.clusters.size() * directions * directions;
  const Layout wants = layout(texels, entries, directions, records);
  uint64_t end = sizeof(header) + sizeof(sections);
  for (size_t i = 0; i < wants.size(); ++i) {
    const Section& section = sections[i];
    const std::string place = fmt::format("section {}", wants[i].name);
    char name[16] = {};
    std::strncpy(name, wants[i].name, sizeof(name) - 1);
    if (std::memcmp(section.name, name, sizeof(name)) != 0) return refuse(place, "here", "another section");
    if (section.dtype != wants[i].dtype)
      return refuse(place + " type", std::to_string(wants[i].dtype), std::to_string(section.dtype));
    if (section.bytes != wants[i].bytes)
      return refuse(place + " size", fmt::format("{} bytes", wants[i].bytes), std::to_string(section.bytes));
    if (section.offset != aligned(end) || section.offset > bytes.size() ||
        section.bytes > bytes.size() - section.offset)
      return refuse(place + " offset", std::to_string(aligned(end)), std::to_string(section.offset));
    end = section.offset + section.bytes;
    if (section.checksum != hash64(bytes.subspan(section.offset, section.bytes)))
      return refuse(place, "its checksum", "other bytes (damaged)");
  }
  spmm.texels.resize(texels);
  spmm.entries.resize(entries);
  spmm.residual.directions.resize(directions);
  spmm.residual.records.resize(records);
  const std::array<void*, 4> targets = {spmm.texels.data(), spmm.entries.data(), spmm.residual.directions.data(),
                                        spmm.residual.records.data()};
  for (size_t i = 0; i < wants.size(); ++i)
    if (wants[i].bytes > 0) std::memcpy(targets[i], bytes.data() + sections[i].offset, wants[i].bytes);
  return {};
}

}  // namespace vamp
