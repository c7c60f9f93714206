#pragma once
// A PNG file as its chunks (PNG specification, third edition): checked as a whole before a decoder sees it, and the
// texts put in and taken out.
#include <string_view>
#include <vector>

#include "engine/image/bytes.h"
#include "engine/image/metadata.h"

namespace vamp {

struct PngHeader {
  uint32_t width = 0;
  uint32_t height = 0;
  int bits = 0;         // per sample: 1, 2, 4, 8, 16
  int colour_type = 0;  // 0 grey, 2 RGB, 3 palette, 4 grey and alpha, 6 RGBA
};

bool is_png(Bytes bytes);

// Every chunk inside the file with the right checksum, IHDR first, IDAT there, IEND last.
Result<PngHeader> check_png(Bytes bytes, std::string_view file);

Result<Metadata> png_texts(Bytes bytes, std::string_view file);

// The same PNG with `texts` (tEXt where ASCII suffices, iTXt else) and, for dpi > 0, its resolution (pHYs) after IHDR.
std::vector<std::byte> png_with_texts(Bytes png, const Metadata& texts, double dpi);

}  // namespace vamp
