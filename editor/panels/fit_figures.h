#pragma once
// What the panels show of a fit that edits do not change, made once for each: shares, which functions a cluster uses.
#include <string>
#include <vector>

#include "editor/model/document.h"
#include "engine/material/reflectance.h"

namespace vamp::ui {

struct FitFigures {
  FitSums sums;
  std::vector<float> share;             // [cluster]: of the texels, 0 to 1
  std::vector<std::vector<int>> bases;  // [cluster]: the functions with any weight in it
};

// The figures of a fit; the last few are kept. The reference stays valid until the next call.
const FitFigures& fit_figures(const SpmmPtr& fit);

// The material that a part or the selection shows, or null.
const MaterialInstance* find_material(const Project& project, int material);

// `cluster 7 “grain”`, or `cluster 7` where it has no name.
std::string cluster_title(const MaterialInstance& material, int cluster);

}  // namespace vamp::ui
