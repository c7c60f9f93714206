#include "engine/image/metadata.h"

#include "engine/image/exr_header.h"
#include "engine/image/load.h"
#include "engine/image/png_chunks.h"

namespace vamp {

Result<Metadata> read_metadata(std::span<const std::byte> bytes, std::string_view file) {
  VAMP_TRY(const ImageFormat format, image_format(bytes, file));
  if (format == ImageFormat::png) return png_texts(bytes, file);
  if (format != ImageFormat::exr) return Metadata{};
  VAMP_TRY(auto header, check_exr(bytes, file));
  return std::move(header.texts);
}

Result<Metadata> read_metadata(const fs::path& path) {
  VAMP_TRY(const auto bytes, read_file(path, ImageLimits{}.bytes));
  return read_metadata(bytes, path.string());
}

}  // namespace vamp
