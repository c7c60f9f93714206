#pragma once
// A rendered picture to a file that knows how it was made.
#include <filesystem>

#include "engine/project/job.h"
#include "engine/render/still.h"

namespace vamp {

struct SnapshotFormat {
  int png_bits = 8;  // 8 or 16
  bool exr_half = false;
  bool transparent = false;  // PNG: alpha from coverage instead of the background
};

// By the extension of `path`: .png (through exposure and tone curve, without layers) or .exr (linear, with layers). The
// job goes into the metadata under "vamp:job". Atomic. Other extensions are ErrorKind::usage; layers in a PNG too.
Status save_snapshot(const Still& still, const Job& job, const std::filesystem::path& path,
                     const SnapshotFormat& format);

// Why save_snapshot would refuse this path and format, before time is spent on rendering.
Status check_snapshot(const std::filesystem::path& path, const StillOptions& options);

}  // namespace vamp
