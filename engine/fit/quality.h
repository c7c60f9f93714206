#pragma once
// How far a fitted material is from a measurement, and other representations beside it.
#include <optional>
#include <string>
#include <vector>

#include "engine/fit/fit.h"
#include "engine/fit/parallel.h"

namespace vamp::fit {

struct QualityOptions {
  std::vector<size_t> ranks = {8, 10};  // of truncated SVDs beside that of equal bytes
  std::vector<size_t> shared = {32};    // terms of one residual for the whole material in place of the clusters'
  size_t max_rank = 160;                // of those of equal bytes
  int threads = 0;
};

// Relative RMSE: |data - model| / |data|, models clamped at 0.
struct Representation {
  std::string name;  // "functions", "with mean", "with 1 term", "svd rank 8", "shared 32", "blinn-phong", "srf"
  uint64_t bytes = 0;
  double nanoseconds = 0;                // of an evaluation on one core of this machine (cost.h); 0: not measured
  double weighted = 0;                   // as the fit weighs pairs
  double uniform = 0;                    // all pairs the same
  std::optional<double> held_out;        // pairs with a direction that the fit did not see; uniform
  std::optional<double> seen;            // the others, where there are any of those
  std::vector<double> rings;             // a polar angle of the view, uniform
  double negative = 0;                   // share of values below -1e-3 of the mean
  double psnr = 0, mssim = 0;            // of texture pictures, one texel a pixel
  double half_psnr = 0, half_mssim = 0;  // two texels a pixel
};

struct Quality {
  std::vector<double> ring_angles;  // degrees
  size_t pictures = 0;              // that PSNR and MSSIM are means of; 0 where the texture is too small
  double functions_per_texel = 0;
  double nanoseconds = 0;  // of an evaluation of the material on one core of this machine, in double
  std::vector<Representation> representations;
};

// `btf` is what the material was fitted to; `against` another measurement of the same texels, or null for the same.
// Truncated SVDs are made from `btf` under the material's directions and read between them by the same interpolation.
Result<Quality> measure_quality(const Spmm& spmm, const Btf& btf, const Btf* against, const QualityOptions& options,
                                Progress* progress = nullptr);

}  // namespace vamp::fit
