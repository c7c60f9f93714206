#pragma once
// What all BTF files of the University of Bonn begin with: signature, description, directions, size (docs/btf.md).
#include <array>
#include <string>
#include <vector>

#include "engine/btf/btf.h"
#include "engine/btf/cursor.h"

namespace vamp {

enum class BonnKind { fmf, dfmf, pvf, bdi };

struct BonnHeader {
  BonnKind kind = BonnKind::bdi;
  std::string signature;
  bool has_rotations = false;  // of the local frames; their list follows
  bool has_extra = false;      // FMF: a dynamic range and a height map follow; BDI: a compression
  std::string setup, sensor, light, xml;
  uint64_t xml_place = 0;   // byte of the XML in the file
  float pixels_per_mm = 0;  // 0: not known
  std::array<float, 3> rgb_scale{1, 1, 1};
  bool has_cosine = false;                           // the values hold the cosine of the light
  std::vector<std::string> channels{"R", "G", "B"};  // or wavelengths in nm
  DirectionSet views, lights;
  uint32_t width = 0, height = 0;
};

bool is_bonn_btf(std::span<const std::byte> bytes);

// Whether this program wrote the file.
bool is_ours(const BonnHeader& header);

// Leaves the cursor behind the height. Errors stay in the cursor too.
Result<BonnHeader> read_bonn_header(Cursor& cursor);

// Version 4 of the description. `alignment`: spaces are put behind the XML until the header's size, `further` bytes
// added, is a multiple of it. Sets the place of the XML.
void write_bonn_header(ByteWriter& writer, BonnHeader& header, size_t further = 0, size_t alignment = 1);

// The header as our own type's, and back. What Bonn's header has no field for stands in an XML element of ours.
BtfInfo info_of(const BonnHeader& header);
BonnHeader bonn_header_of(const BtfInfo& info, BonnKind kind);

}  // namespace vamp
