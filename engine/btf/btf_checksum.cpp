#include "engine/btf/btf_checksum.h"

#include <optional>

#include "engine/btf/btf_xml.h"
#include "engine/core/check.h"
#include "engine/core/hash.h"

namespace vamp {
namespace {

constexpr size_t kDigits = 16;

// Of all bytes but the digits themselves, which begin at `digits`.
std::string checksum_around(std::span<const std::byte> bytes, uint64_t digits) {
  return fmt::format("{:016x}", hash64(bytes.subspan(digits + kDigits), hash64(bytes.first(digits))));
}

// Where the digits stand in the file.
std::optional<uint64_t> digits_place(std::span<const std::byte> bytes, const BonnHeader& header) {
  const auto in_xml = checksum_place(header.xml);
  if (!in_xml || header.xml_place + *in_xml + kDigits > bytes.size()) return {};
  return header.xml_place + *in_xml;
}

}  // namespace

void write_checksum(std::span<std::byte> bytes, const BonnHeader& header) {
  const auto place = digits_place(bytes, header);
  CHECK(place);
  const std::string digits = checksum_around(bytes, *place);
  std::memcpy(bytes.data() + *place, digits.data(), kDigits);
}

Status check_checksum(std::span<const std::byte> bytes, const BonnHeader& header, std::string_view file) {
  if (!is_ours(header)) return {};
  const auto place = digits_place(bytes, header);
  if (!place)
    return fail(ErrorKind::bad_input, file, fmt::format("byte {}, XML", header.xml_place), "a checksum", "none");
  const std::string expected = checksum_around(bytes, *place);
  const std::string_view found(reinterpret_cast<const char*>(bytes.data()) + *place, kDigits);
  if (found == expected) return {};
  return fail(ErrorKind::bad_input, file, fmt::format("byte {}, checksum", *place), expected,
              fmt::format("{}: the file is damaged", found));
}

}  // namespace vamp
