#pragma once
// The measurements that `vamp bench fit` judges fits by: made-up materials, each under UBO2003's directions and under
// others between those.
#include <span>
#include <string>
#include <vector>

#include "engine/btf/btf.h"
#include "engine/core/progress.h"

namespace vamp {

struct FitMaterial {
  const char* name;
  bool judged;  // held to what is asked of fits; the others are there to show where fits end
  std::vector<std::pair<const char*, float>> settings;
};
// Judged: three leathers and three cloths, steep and shallow. Beside them a glazed crocodile, whose highlights are
// narrower than the directions lie apart.
std::span<const FitMaterial> fit_materials();

// Paths of what fits are judged by, as a factor: its noise is in every figure.
inline constexpr int kPathsBetween = 8;

struct FitDataOptions {
  fs::path cache;
  int size = 64;     // texels
  int samples = 25;  // paths of a texel and view; kPathsBetween times as many between
  bool all = true;   // fits with few functions, with many, and without a ring too, which take longest
};

struct FitData {
  Btf measured, between;
  double noise = 0, noise_between = 0;  // root mean square of all values' standard errors, relative
  double tilt = 0;                      // mean angle of what is seen from above to the plane, degrees
};

// From the cache where it is there; what was begun is gone on with.
Result<FitData> fit_data(const FitMaterial& material, const FitDataOptions& options, Progress& progress);

}  // namespace vamp
