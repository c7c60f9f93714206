// From pictures, each of which holds one value of every texel, to texels, each of which holds all its values; and back.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/btf/image_folder.h"
#include "engine/btf/image_names.h"
#include "engine/core/jobs.h"
#include "engine/image/load.h"
#include "engine/image/save.h"

namespace vamp {
namespace {

// Of the pictures that are held at once.
constexpr size_t kBatchBytes = size_t{256} << 20;

// Linear Rec.709 from XYZ under D65 (ITU-R BT.709).
constexpr float kRec709FromXyz[9] = {3.2404542f, -1.5371385f, -0.4985314f, -0.9692660f, 1.8760108f,
                                     0.0415560f, 0.0556434f,  -0.2040259f, 1.0572252f};

Image from_xyz(const Image& image, size_t x, size_t y, size_t z) {
  Image rgb(image.width, image.height, {"R", "G", "B"});
  const size_t channels = image.channels.size();
  for (size_t i = 0; i < image.pixel_count(); ++i) {
    const float* in = image.pixels.data() + i * channels;
    for (size_t c = 0; c < 3; ++c) {
      const float* row = kRec709FromXyz + 3 * c;
      rgb.pixels[3 * i + c] = row[0] * in[x] + row[1] * in[y] + row[2] * in[z];
    }
  }
  return rgb;
}

bool stopped(Progress* progress, size_t done, size_t all) {
  if (progress == nullptr) return false;
  progress->fraction(static_cast<float>(done) / static_cast<float>(all));
  return progress->cancelled();
}

// How many pictures of this BTF are held at once: some of the lights of one view.
size_t batch_size(const BtfInfo& info) {
  return std::clamp<size_t>(kBatchBytes / (info.texel_count() * 3 * sizeof(Half)), 1, info.lights.size());
}

}  // namespace

Result<Image> read_picture(const fs::path& path, PictureCurve curve) {
  VAMP_TRY(const auto bytes, read_file(path, ImageLimits{}.bytes));
  const std::string file = path.string();
  VAMP_TRY(const ImageFormat format, image_format(bytes, file));
  const ColourSpace space = curve == PictureCurve::srgb ? ColourSpace::srgb : ColourSpace::linear;
  VAMP_TRY(Image image, decode_image(bytes, file, space));
  const auto x = image.channel("X"), y = image.channel("Y"), z = image.channel("Z");
  if (x && y && z) return from_xyz(image, *x, *y, *z);
  VAMP_TRY(image, colour_of(image, "", file));
  if (curve == PictureCurve::gamma22 && is_display_format(format))
    for (float& value : image.pixels) value = std::pow(value, 2.2f);
  return image;
}

Result<BtfInfo> info_of(const ImageSet& images) {
  const fs::path& first = images.files.front();
  VAMP_TRY(const auto bytes, read_file(first, ImageLimits{}.bytes));
  VAMP_TRY(const ImageInfo picture, image_info(bytes, first.string()));
  BtfInfo info;
  info.width = static_cast<uint32_t>(picture.width);
  info.height = static_cast<uint32_t>(picture.height);
  info.views = images.views;
  info.lights = images.lights;
  info.name = fs::weakly_canonical(images.source).stem().string();
  info.provenance = fmt::format("{} pictures", images.files.size());
  return info;
}

Status read_images(const ImageSet& images, Btf& out, PictureCurve curve, Progress* progress) {
  const BtfInfo& info = out.info();
  const size_t lights = info.lights.size(), texels = info.texel_count(), batch = batch_size(info);
  std::vector<Half> pictures(batch * texels * 3);
  if (progress != nullptr) progress->stage("Reading pictures");
  for (size_t view = 0; view < info.views.size(); ++view)
    for (size_t first = 0; first < lights; first += batch) {
      const size_t count = std::min(batch, lights - first);
      for (size_t i = 0; i < count; ++i) {
        const size_t index = view * lights + first + i;
        if (stopped(progress, index, images.files.size())) return JobQueue::cancelled_error();
        const fs::path& path = images.files[index];
        VAMP_TRY(const Image picture, read_picture(path, curve));
        if (picture.width != static_cast<int>(info.width) || picture.height != static_cast<int>(info.height))
          return fail(ErrorKind::bad_input, path.string(), "size", fmt::format("{} x {}", info.width, info.height),
                      fmt::format("{} x {}", picture.width, picture.height));
        std::ranges::transform(picture.pixels, pictures.begin() + static_cast<std::ptrdiff_t>(i * texels * 3),
                               [](float value) { return half_from_float(std::clamp(value, -kHalfMax, kHalfMax)); });
      }
      for (size_t t = 0; t < texels; ++t) {
        const auto values = out.writable_texel(t).subspan((view * lights + first) * 3, count * 3);
        for (size_t i = 0; i < count; ++i)
          std::copy_n(pictures.begin() + static_cast<std::ptrdiff_t>((i * texels + t) * 3), 3,
                      values.begin() + static_cast<std::ptrdiff_t>(3 * i));
      }
      out.forget(0, texels);
    }
  return {};
}

Status write_images(const Btf& btf, const fs::path& folder, PictureFormat format, Progress* progress) {
  std::error_code code;
  fs::create_directories(folder, code);
  const bool empty = !code && fs::is_empty(folder, code);
  if (code) return fail(ErrorKind::io, folder.string(), "", "cannot be written: " + code.message());
  if (!empty) return fail(ErrorKind::io, folder.string(), "", "an empty folder", "one with files in it");
  const BtfInfo& info = btf.info();
  const size_t lights = info.lights.size(), texels = info.texel_count(), batch = batch_size(info);
  std::vector<Image> pictures(batch,
                              Image(static_cast<int>(info.width), static_cast<int>(info.height), {"R", "G", "B"}));
  if (progress != nullptr) progress->stage("Writing pictures");
  for (size_t view = 0; view < info.views.size(); ++view)
    for (size_t first = 0; first < lights; first += batch) {
      const size_t count = std::min(batch, lights - first);
      for (size_t t = 0; t < texels; ++t) {
        const auto values = btf.texel(t).subspan((view * lights + first) * 3, count * 3);
        for (size_t i = 0; i < values.size(); ++i) pictures[i / 3].pixels[3 * t + i % 3] = float_from_half(values[i]);
      }
      for (size_t i = 0; i < count; ++i) {
        if (stopped(progress, view * lights + first + i, info.views.size() * lights))
          return JobQueue::cancelled_error();
        const fs::path path = folder / image_name(info.lights[first + i], info.views[view]);
        VAMP_CHECK_STATUS(format == PictureFormat::exr ? save_exr(path.string() + ".exr", pictures[i], {.half = true})
                                                       : save_png(path.string() + ".png", pictures[i]));
      }
    }
  return {};
}

}  // namespace vamp
