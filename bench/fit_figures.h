#pragma once
// What is found of one material: the figures of bench/fit.cpp, kept as JSON between runs.
#include "bench/fit_data.h"
#include "engine/core/json.h"

namespace vamp {

// A representation: {"name", "kib", "ns", "measured", "between", "mssim"}; errors relative RMSE, mssim at two texels a
// pixel over pictures between the measured directions.
// The whole: {"noise", "noise_between", "tilt", "curve": [..], "small_curve": [..], "few": .., "few_any": .., "any":
// .., "ring": ..}.
Result<Json> fit_figures(const FitMaterial& material, const FitDataOptions& options, int threads, Progress& progress);

// As vamp fit has it.
inline constexpr int kFitClusters = 32;
// Where bytes count: of 64 x 64 texels, as many to a cluster as vamp fit has of 128 x 128.
inline constexpr int kSmallFitClusters = 8;

}  // namespace vamp
