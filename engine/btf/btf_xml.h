#pragma once
// What Bonn's header has no field for, as one XML element inside its XML text:
//   <vamp name="felt05" provenance="..." licence="..." mm_per_texel="0.0625" synthetic="no"
//    checksum="0123456789abcdef"/>
#include <optional>
#include <string>
#include <string_view>

#include "engine/btf/btf.h"

namespace vamp {

// The checksum's 16 digits are 0.
std::string btf_xml(const BtfInfo& info);
bool has_btf_xml(std::string_view xml);
// Where the checksum's digits stand in the text.
std::optional<size_t> checksum_place(std::string_view xml);

// Fills in what the element says; false, and nothing filled in, when there is none.
bool read_btf_xml(std::string_view xml, BtfInfo& info);

}  // namespace vamp
