#pragma once
// A measured BTF becomes a material that can be edited: the whole of docs/fitting.md, from texels to preset.
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/btf/btf.h"
#include "engine/core/progress.h"
#include "engine/fit/curve.h"
#include "engine/material/spmm.h"

namespace vamp::fit {

enum class Weights { elimination, group_lasso, stagewise_lasso };

struct FitOptions {
  int clusters = 32;         // 1 to 256; share a residual
  int representatives = 8;   // texels of each cluster that lobes are fitted to
  int functions = 11;        // of a texel, at most
  int terms = 4;             // of the residual, 0 to 4; -1 leaves the residual out
  int bases = 32;            // of the dictionary; per cluster where `per_cluster`
  double error = 0;          // relative RMSE that the functions may leave: as few as reach it; 0: see `slack`
  double slack = 0.05;       // without `error`: of the error with all functions, what fewer may cost more
  bool per_cluster = false;  // each cluster a dictionary of its own, as in the paper
  Weights weights = Weights::elimination;
  uint64_t seed = 1;
  int threads = 0;               // 0: as many as the machine has
  bool curve = false;            // also tell what fewer functions would cost (report.curve)
  std::vector<double> left_out;  // rings of directions that take no part, degrees; for tests of what lies between
};

struct FitReport {
  double square = 0;               // of all weighted values
  std::vector<double> errors;      // relative RMSE: functions alone, with mean, with 1, 2 .. terms
  double all_functions_error = 0;  // with the most functions that a texel may have
  double functions_per_texel = 0;
  std::vector<size_t> histogram;                        // texels with 0, 1 .. functions
  int representatives = 0, candidates = 0;              // texels that lobes were fitted to; functions found in them
  double representative_error = 0;                      // mean relative RMSE of their own lobes
  std::vector<bool> filler;                             // a function
  std::vector<CurvePoint> curve;                        // where it was asked for
  std::vector<std::pair<std::string, double>> seconds;  // a stage
};

struct FitResult {
  Spmm spmm;
  FitReport report;
};

// The same result for a seed whatever the number of threads. bad_input for measurements that functions cannot stand for
// (signed logarithms, a single view); interrupted when `progress` was cancelled.
Result<FitResult> fit_spmm(const Btf& btf, const FitOptions& options, Progress* progress = nullptr);

}  // namespace vamp::fit
