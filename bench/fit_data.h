#pragma once
// The measurements that `vamp bench fit` judges fits by: six made-up materials, each under UBO2003's directions and
// under others between those.
#include <span>
#include <string>
#include <vector>

#include "engine/btf/btf.h"
#include "engine/core/progress.h"

namespace vamp {

struct FitMaterial {
  const char* name;
  bool cloth;
  bool steep;  // deep enough that shadows and parallax make the picture
  std::vector<std::pair<const char*, float>> settings;
};
// Three leathers and three cloths, steep and shallow.
std::span<const FitMaterial> fit_materials();

struct FitDataOptions {
  fs::path cache;
  int size = 64;     // texels
  int samples = 25;  // paths of a texel and view; twice as many between
  bool many = true;  // fits with many functions too, which take longest
};

struct FitData {
  Btf measured, between;
  double noise = 0, noise_between = 0;  // root mean square of all values' standard errors, relative
};

// From the cache where it is there; what was begun is gone on with.
Result<FitData> fit_data(const FitMaterial& material, const FitDataOptions& options, Progress& progress);

}  // namespace vamp
