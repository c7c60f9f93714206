#pragma once
// How good fits are: six acquired materials, each representation's error on measured directions and between them
// against its bytes and the time of an evaluation, and what docs/fitting.md asks of them.
#include "bench/fit_data.h"
#include "bench/report.h"
#include "engine/image/figure.h"

namespace vamp {

struct FitBench {
  FitDataOptions data;
  std::vector<std::string> materials;  // of fit_materials(); none: all
  int threads = 0;
};

struct FitCurves {
  Report report;
  Figure by_bytes, by_time;
};

// Measurements and each material's figures lie in the cache: what is there is not made again. interrupted when
// cancelled.
Result<FitCurves> bench_fit(const FitBench& options, Progress& progress);

}  // namespace vamp
