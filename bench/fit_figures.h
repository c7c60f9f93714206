#pragma once
// What is found of one material: the figures of bench/fit.cpp, kept as JSON between runs.
#include "bench/fit_data.h"
#include "engine/core/json.h"

namespace vamp {

// A representation: {"name", "kib", "ns", "measured", "between", "mssim"}; errors relative RMSE, mssim at two texels a
// pixel over pictures between the measured directions.
// The whole: {"noise", "noise_between", "curves": {"4 clusters": [..], ..}, "few": .., "few_any": .., "any": ..,
// "ring": ..}.
Result<Json> fit_figures(const FitMaterial& material, const FitDataOptions& options, int threads, Progress& progress);

// The clusters of the fit that all bars are held against; the curves have others beside it.
inline constexpr int kFitClusters = 8;

}  // namespace vamp
