#pragma once
// A JPEG file as its markers (ITU-T T.81, annex B): libjpeg fills what a truncated file lacks with grey and goes on, so
// that completeness is looked at here.
#include <string_view>

#include "engine/core/error.h"
#include "engine/image/bytes.h"

namespace vamp {

struct JpegHeader {
  uint32_t width = 0;
  uint32_t height = 0;
};

bool is_jpeg(Bytes bytes);

// Segments inside the file, a frame header, a scan, and the end marker after it.
Result<JpegHeader> check_jpeg(Bytes bytes, std::string_view file);

}  // namespace vamp
