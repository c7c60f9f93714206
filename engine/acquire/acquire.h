#pragma once
// The virtual goniometer's job: measures a mesostructure under every pair of directions into a .btf file.
#include <string>

#include "engine/acquire/goniometer.h"
#include "engine/btf/btf.h"
#include "engine/core/json.h"

namespace vamp {
class Progress;
}

namespace vamp::acquire {

struct Options {
  int size = 128;           // texels across the period, 1 to 4096
  DirectionSet directions;  // of views and of lights
  int samples = 16;         // paths for each texel and view, 1 to 65536
  uint64_t seed = 1;
  Shadows shadows = Shadows::tabulated;
  int threads = 0;  // 0: one per core; without influence on the result
  // What was asked for, as it goes into the provenance. Work that was stopped goes on only under the same words.
  Json job;
};

// Standard error of a texel's values: the root mean square over views, lights and channels, as a share of the root mean
// square of the values themselves. From the differences between neighbouring strata of a texel, so texture within the
// texel counts as noise and the truth is a little less. 0 where one sample leaves nothing to compare.
struct Report {
  double median_error = 0, mean_error = 0, worst_error = 0;
  double paths = 0;      // of this run
  int resumed_rows = 0;  // that were there already
};

// Progress moves with the rows of texels. The work lies in `path`.part and `path`.part.json until it is whole, then
// takes its name. When it is stopped (interrupted) or fails, both stay, and the next call with the same job goes on
// from there and ends with the same bytes; those of another job are replaced. An old file at `path` stays until then.
Result<Report> measure(Mesostructure structure, const Options& options, const fs::path& path, Progress& progress);

// The same into memory. errors[texel] as above; not stoppable halfway.
Result<Btf> measure_in_memory(Mesostructure structure, const Options& options, std::vector<float>& errors);

}  // namespace vamp::acquire
