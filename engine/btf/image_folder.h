#pragma once
// BTFs as a folder of pictures, one for each pair of light and view, named after their angles (UBO2003, ATRIUM,
// SPECTRAL, UTIA).
#include <string>
#include <vector>

#include "engine/btf/btf.h"
#include "engine/core/progress.h"
#include "engine/image/image.h"

namespace vamp {

// What the codes of JPEG and PNG pictures mean; which of them is not told by the data sets. OpenEXR and HDR are linear.
enum class PictureCurve {
  srgb,
  gamma22,  // code^2.2
  linear,
};

struct ImageSet {
  fs::path source;  // the folder, or the list that names the pictures
  DirectionSet views, lights;
  std::vector<fs::path> files;  // [view * lights + light]
};

// Directions are sorted by theta, then phi. Looks through the folder and its sub-folders; other files are left alone.
// bad_input when no picture has angles in its name, when a pair is there twice or not at all.
Result<ImageSet> find_images(const fs::path& folder);

// Size of the first picture, no physical size. bad_input when it cannot be read.
Result<BtfInfo> info_of(const ImageSet& images);

// Reads the pictures into a BTF of that size and those directions, so many at a time that they take 256 MiB of memory.
// bad_input: damaged, not finite, of another size. X, Y and Z of OpenEXR are converted from D65.
Status read_images(const ImageSet& images, Btf& out, PictureCurve curve, Progress* progress = nullptr);

// One picture as R, G and B of linear Rec.709.
Result<Image> read_picture(const fs::path& path, PictureCurve curve);

enum class PictureFormat { exr, png };

// OpenEXR of halfs, which keeps every value; PNG of 8 bits in sRGB, cut off at 0 and 1. The folder must be empty or
// new.
Status write_images(const Btf& btf, const fs::path& folder, PictureFormat format, Progress* progress = nullptr);

}  // namespace vamp
