#pragma once
// The spatial reflectance field of Ma et al. 2004 as a material that the renderer knows: a light-weight second kind.
#include "engine/btf/btf.h"
#include "engine/core/progress.h"
#include "engine/material/spmm.h"

namespace vamp::fit {

struct SrfOptions {
  int clusters = 4;  // 1 to 256
  uint64_t seed = 1;
  int threads = 0;  // 0: as many as the machine has
};

struct SrfReport {
  double exact_error = 0;   // relative RMSE of the field itself
  double stored_error = 0;  // of what the material holds of it, at the measured directions
};

struct SrfResult {
  Spmm spmm;
  SrfReport report;
};

// Ma's sum kd (N L) + ks (N H)^n + s(P) H, an s for each channel of each texel. The first summand is one Lambert
// function, exact. The others do not have the form of functions times weights that are not negative; they become the
// residual's tables, read between directions as any residual is, with s(P), nine numbers, as the mean and four axes
// of its cluster: four numbers a texel. `stored_error` says what that costs. bad_input as for fit_spmm, and where views
// and lights differ; interrupted when cancelled.
Result<SrfResult> fit_srf(const Btf& btf, const SrfOptions& options, Progress* progress = nullptr);

}  // namespace vamp::fit
