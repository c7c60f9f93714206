#pragma once
// Checksums of files and tables (XXH3).
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

namespace vamp {

uint64_t hash64(std::span<const std::byte> bytes, uint64_t seed = 0);

// 32 hexadecimal digits of the 128-bit checksum.
std::string checksum(std::span<const std::byte> bytes);

}  // namespace vamp
