#include "bench/measured.h"

#include "engine/core/jobs.h"
#include "engine/core/progress.h"

namespace vamp {

Result<Report> bench_measured(const std::filesystem::path& data, Progress& progress) {
  Report report("measured", "UBO2014 felt05 and carpet07 (chroma alone), 72 photographs of a gilded icon, 3M tape.");
  VAMP_CHECK_STATUS(measure_chroma(data / "btf-ubo2014-chroma", report, progress));
  VAMP_CHECK_STATUS(measure_photographs(data / "rti-icon/exampledataset/dirs.lp", report, progress));
  VAMP_CHECK_STATUS(measure_tape(data / "brdf-raw/retro-3M-jaune.dat", report, progress));
  if (progress.cancelled()) return JobQueue::cancelled_error();
  return report;
}

}  // namespace vamp
