#pragma once
// Work split over threads in a way that its results do not show.
#include <atomic>
#include <cstddef>
#include <functional>
#include <string>

#include "engine/core/progress.h"

namespace vamp::fit {

// How a fit runs: on how many threads, and who looks on.
struct Worker {
  int threads = 2;
  Progress* progress = nullptr;  // may be null

  bool cancelled() const { return progress != nullptr && progress->cancelled(); }
  void stage(const std::string& label) const;
  // How much of the stage is done, of work that does not run in each().
  void done(int part, int of) const;

  // work(i) for i = 0 .. count - 1, in any order on any thread; each i writes only what is its own. After a cancel the
  // rest is left out. The progress's fraction runs from 0 to 1.
  void each(size_t count, const std::function<void(size_t)>& work) const;
};

}  // namespace vamp::fit
