#pragma once
// Photographs from one place under known lights (Reflectance Transformation Imaging): an .lp file lists the pictures
// and the directions of their lights. They are a BTF with one view, along the normal.
#include "engine/btf/image_folder.h"

namespace vamp {

// First line: how many; then "file x y z", the light's direction or position from the middle of the object, z towards
// the camera; normalised here, but where most are unit vectors all must be. Files are looked for beside the list; of a
// path from another machine its last part counts. bad_input: another count, numbers that are not finite, lights at or
// below the plane, files outside the folder.
Result<ImageSet> read_light_list(const fs::path& path);
// The same without looking for the files, which stay as they are written.
Result<ImageSet> parse_light_list(std::string_view text, std::string_view file);

// The directions with these names, in the same order. Names with line breaks are a programming error.
Status write_light_list(const fs::path& path, std::span<const std::string> files, const DirectionSet& lights);

}  // namespace vamp
