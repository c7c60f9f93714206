#pragma once
// tables.bin: the heavy part of a preset. Little-endian.
//   header, 32 bytes: magic "VAMPTABL", u32 version, u32 section count, u64 file size, u64 XXH3 of the section table
//   section table, 48 bytes each: char name[16] (zero-padded), u32 dtype, u32 0, u64 offset, u64 bytes, u64 XXH3
//   sections, each at a multiple of 16
// dtype: 1 u32, 2 f32, 3 f16.
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

#include "engine/material/spmm.h"

namespace vamp {

std::vector<std::byte> encode_tables(const Spmm& spmm);

// Fills texels, entries and the residual's directions and records of `spmm`, whose sizes, clusters, residual terms and
// counts of entries and directions (`entries`, `directions`) are known from material.json. bad_input with the place
// when anything differs from what they make it, or a checksum from the bytes.
Status decode_tables(std::span<const std::byte> bytes, std::string_view file, size_t entries, size_t directions,
                     Spmm& spmm);

// Exact size of the file that encode_tables makes.
uint64_t tables_size(size_t texels, size_t entries, size_t directions, size_t records);

}  // namespace vamp
