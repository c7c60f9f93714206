#pragma once
// The lobes of one texel, found from nothing: the best of a library of coarse lobes is added and refined, again and
// again.
#include <vector>

#include "engine/fit/rows.h"
#include "engine/fit/varpro.h"

namespace vamp::fit {

// Lobes of all models in coarse steps of their parameters and frames, each column of unit length.
struct LobeLibrary {
  std::vector<Basis> bases;
  Rows columns;
};
LobeLibrary make_lobe_library(const Pairs& pairs, const std::vector<float>& roots, const LobeLimits& limits);

struct LobeFitOptions {
  size_t max_lobes = 8;
  double min_gain = 0.004;  // of the error's root; a lobe that gains less is the last
  size_t candidates = 4;    // models whose best atom is refined before one is chosen
};

struct LobeFit {
  std::vector<Basis> bases;
  double relative_error = 0;  // relative RMSE
};

// Lobes of a texel (three rows as Measurement::read gives them), best fit last changed jointly; `start` are lobes to
// begin with.
LobeFit fit_lobes(const Pairs& pairs, const std::vector<float>& roots, const LobeLibrary& library,
                  const LobeLimits& limits, const float* texel, const LobeFitOptions& options,
                  std::vector<Basis> start = {});

}  // namespace vamp::fit
