#pragma once
// The zip form of a preset: whole members in memory, read with limits, written without anything that varies.
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/error.h"

namespace vamp {

struct ZipMember {
  std::string name;
  std::vector<std::byte> bytes;
};

// Which members to read, and how large each may be when unpacked.
struct ZipWant {
  std::string_view name;
  uint64_t limit = 0;
  bool required = true;
};

// The wanted members that are there, in the order of `wants`. Nothing is ever unpacked to disk; names with folders or
// "..", encryption, damage and members over their limit are refused. Other plain names are passed over.
Result<std::vector<ZipMember>> read_zip(std::span<const std::byte> bytes, std::string_view file,
                                        std::span<const ZipWant> wants);

// Deflated; dates fixed, so that the same members make the same bytes.
Result<std::vector<std::byte>> write_zip(std::span<const ZipMember> members, std::string_view file);

}  // namespace vamp
