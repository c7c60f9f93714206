#pragma once
// The sums of the fits met so far, so that a material that is put on another part need not be summed again.
#include <memory>
#include <utility>
#include <vector>

#include "engine/material/reflectance.h"

namespace vamp {

class KnownSums {
 public:
  // Made at the first call for a fit, forgotten with it.
  std::shared_ptr<const FitSums> of(const SpmmPtr& fit);

 private:
  std::vector<std::pair<std::weak_ptr<const Spmm>, std::shared_ptr<const FitSums>>> known_;
};

}  // namespace vamp
