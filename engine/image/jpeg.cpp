#include "engine/image/jpeg.h"

#include <fmt/format.h>

namespace vamp {

bool is_jpeg(Bytes bytes) { return as_text(bytes).starts_with("\xff\xd8\xff"); }

Result<JpegHeader> check_jpeg(Bytes bytes, std::string_view file) {
  if (!is_jpeg(bytes)) return fail(ErrorKind::bad_input, file, "", "a JPEG file", "another signature");
  const auto byte = [bytes](size_t at) { return std::to_integer<uint32_t>(bytes[at]); };
  JpegHeader header;
  for (size_t at = 2; at + 4 <= bytes.size();) {
    const uint32_t marker = byte(at + 1);
    if (byte(at) != 0xff)
      return fail(ErrorKind::bad_input, file, fmt::format("byte {}", at), "a JPEG marker", "other bytes");
    if (marker == 0xff) {  // fill byte
      ++at;
      continue;
    }
    const size_t length = byte(at + 2) << 8 | byte(at + 3);
    if (length < 2 || length > bytes.size() - at - 2)
      return fail(ErrorKind::bad_input, file, fmt::format("byte {}", at), "a JPEG segment",
                  "one that passes the end of the file");
    // Frame headers are C0 to CF but for DHT, JPG and DAC.
    const bool frame = marker >= 0xc0 && marker <= 0xcf && marker != 0xc4 && marker != 0xc8 && marker != 0xcc;
    if (frame && length >= 8) header = {byte(at + 7) << 8 | byte(at + 8), byte(at + 5) << 8 | byte(at + 6)};
    at += 2 + length;
    if (marker != 0xda) continue;
    // In scan data FF is followed by 00, so that the end marker cannot stand there by chance.
    if (header.width == 0 || header.height == 0)
      return fail(ErrorKind::bad_input, file, "", "a JPEG frame header before the scan", "none");
    if (as_text(bytes.subspan(at)).find("\xff\xd9") == std::string_view::npos)
      return fail(ErrorKind::bad_input, file, "", "a JPEG end marker", "the end of the file");
    return header;
  }
  return fail(ErrorKind::bad_input, file, "", "a JPEG scan", "the end of the file");
}

}  // namespace vamp
