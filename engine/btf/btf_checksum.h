#pragma once
// The .btf files that this program writes carry a checksum in their XML element, since Bonn's formats have none: of the
// whole file where it is factorised, of all that stands before the values where it is not.
#include "engine/btf/bonn_header.h"

namespace vamp {

// Puts the checksum of `bytes`, which begin a file with the header, into the header's XML.
void write_checksum(std::span<std::byte> bytes, const BonnHeader& header);

// bad_input when the file is ours and `bytes` do not have the checksum that it says. Files of others have none.
Status check_checksum(std::span<const std::byte> bytes, const BonnHeader& header, std::string_view file);

}  // namespace vamp
