#pragma once
// The texts that a picture carries: PNG tEXt, zTXt and iTXt chunks, string attributes of OpenEXR.
#include <cstddef>
#include <map>
#include <span>
#include <string>
#include <string_view>

#include "engine/core/error.h"
#include "engine/core/files.h"

namespace vamp {

// Keys: 1 to 79 printable ASCII characters without leading, trailing or double spaces. Values: UTF-8; zero bytes are
// dropped when they are written. "vamp:job" holds a snapshot's job as JSON; the rest follows the PNG specification's
// words (Title, Software, Creation Time, Comment).
using Metadata = std::map<std::string, std::string>;

// All texts of a PNG or OpenEXR file; empty for JPEG and Radiance HDR, bad_input for anything else or damaged files.
Result<Metadata> read_metadata(const fs::path& path);
Result<Metadata> read_metadata(std::span<const std::byte> bytes, std::string_view file);

}  // namespace vamp
