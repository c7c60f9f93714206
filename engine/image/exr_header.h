#pragma once
// The header of an OpenEXR file (OpenEXR File Layout, version 2), read before the library sees the file: damaged window
// sizes and offset tables make it allocate gigabytes or search for minutes.
#include <array>
#include <optional>
#include <string_view>
#include <vector>

#include "engine/image/bytes.h"
#include "engine/image/metadata.h"

namespace vamp {

struct ExrHeader {
  uint32_t width = 0;  // of the data window
  uint32_t height = 0;
  std::vector<std::string> channels;
  std::vector<bool> is_half;                           // else 32 bit float
  std::optional<std::array<float, 8>> chromaticities;  // x and y of red, green, blue, white
  Metadata texts;
};

bool is_exr(Bytes bytes);

// A flat single-part file of half and float channels, none of them subsampled, whose chunk table is inside the file.
Result<ExrHeader> check_exr(Bytes bytes, std::string_view file);

}  // namespace vamp
