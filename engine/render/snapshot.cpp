#include "engine/render/snapshot.h"

#include <algorithm>
#include <cctype>
#include <string>

#include "engine/core/text.h"
#include "engine/image/display.h"
#include "engine/image/save.h"

namespace vamp {
Status check_snapshot(const std::filesystem::path& path, const StillOptions& options) {
  const std::string extension = lower_extension(path);
  if (extension != ".png" && extension != ".exr")
    return fail(ErrorKind::usage, path.string(), "extension", ".png or .exr", extension.empty() ? "none" : extension);
  if (extension == ".png" && !options.layers.empty())
    return fail(ErrorKind::usage, path.string(), "layers", "a .exr file for layers such as depth", ".png");
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  std::error_code code;
  if (!std::filesystem::is_directory(folder, code))
    return fail(ErrorKind::io, path.string(), "", "an existing folder", folder.string());
  return {};
}

Status save_snapshot(const Still& still, const Job& job, const std::filesystem::path& path,
                     const SnapshotFormat& format) {
  const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
  VAMP_TRY(const std::string text, job_to_text(job, folder));
  Metadata metadata = {{"Software", "Vamp"}, {std::string(kJobKey), text}};
  if (lower_extension(path) == ".exr")
    return save_exr(path, still.image, {.half = format.exr_half, .metadata = metadata});

  const DisplaySettings& shown = job.project.display;
  const ToneCurve curve = shown.tone_map == ToneMap::pbr_neutral ? ToneCurve::neutral : ToneCurve::linear;
  const std::vector<std::string> names = {"R", "G", "B", "A"};
  Image picture = select_channels(still.image, std::span(names).first(format.transparent ? 4 : 3));
  VAMP_TRY(picture, displayed(picture, {.exposure = shown.exposure, .curve = curve}));
  return save_png(path, picture, {.bits = format.png_bits, .metadata = metadata});
}

}  // namespace vamp
