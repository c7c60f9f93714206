#pragma once
// What a BTF file says of itself, without decoding its values.
#include <string>
#include <vector>

#include "engine/btf/load_btf.h"

namespace vamp {

struct BtfSummary {
  BtfFormat format = BtfFormat::bdi;
  BtfInfo info;
  std::string colour;                 // "log Y, U / Y, V / Y", "sRGB or linear pictures"
  std::vector<std::string> channels;  // as the file names them
  std::vector<size_t> components;     // of factorised files, per set of factors
  bool has_cosine = true;             // of the light, in the file; ours always have it
  size_t rotation_count = 0;          // of local frames, which are not applied
  uint64_t bytes = 0;                 // of the file, or of all pictures
  uint64_t decoded_bytes = 0;         // of a Btf
  bool mapped = false;                // values are used where they lie
};

// Checks as much as reading does, but for the values of BDI files and the pixels of pictures.
Result<BtfSummary> summary_of(const fs::path& path);

}  // namespace vamp
