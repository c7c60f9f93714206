#pragma once
// BDI, Bonn's unfactored BTF: behind the header chunks of whole rows of texels, each behind its size in bytes. Texels
// that the mask leaves out are not stored.
#include <optional>

#include "engine/btf/bonn_header.h"
#include "engine/core/progress.h"

namespace vamp {

struct BdiHeader {
  BonnHeader bonn;
  uint32_t rows_per_chunk = 0;
  std::span<const std::byte> mask;  // per texel, 0: not stored
  uint64_t rotation_count = 0;      // of local frames, which are not applied
  uint64_t stored_texels = 0;       // those that the mask leaves in
  uint64_t first_texel = 0;         // byte of the first stored texel
  uint64_t texels_per_chunk = 0;
  uint64_t bytes_per_texel = 0;

  // Where the i-th stored texel lies.
  uint64_t offset(uint64_t i) const {
    return first_texel + i * bytes_per_texel + i / texels_per_chunk * sizeof(uint32_t);
  }
};

// Reads and checks everything but the values: all chunks are there, of the right size, and nothing comes after them.
Result<BdiHeader> read_bdi_header(std::span<const std::byte> bytes, std::string_view file);

// Why the values cannot be used where they lie, as what was found; nothing when they can.
std::optional<std::string> why_not_mapped(const BdiHeader& header);

// The values of the file `bytes` as a BTF of the same size and directions has them: linear Rec.709 with the cosine;
// texels that are not stored stay as they are. bad_input when a value is not finite; cancelled when `progress` says so.
Status decode(const BdiHeader& header, std::span<const std::byte> bytes, Btf& out, std::string_view file,
              Progress* progress = nullptr);

}  // namespace vamp
