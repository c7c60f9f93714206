#include "engine/material/known_sums.h"

#include <algorithm>

namespace vamp {

std::shared_ptr<const FitSums> KnownSums::of(const SpmmPtr& fit) {
  std::erase_if(known_, [](const auto& known) { return known.first.expired(); });
  const auto at = std::find_if(known_.begin(), known_.end(), [&](const auto& k) { return k.first.lock() == fit; });
  if (at != known_.end()) return at->second;
  return known_.emplace_back(fit, std::make_shared<const FitSums>(fit_sums(*fit))).second;
}

}  // namespace vamp
