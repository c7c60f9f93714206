#pragma once
// Independent pieces of work on several threads.
#include <functional>

namespace vamp::acquire {

// Runs work(i) for i in [0, count), in any order, on `threads` threads (0: one per core), this one included. Stops
// early when work returns false; false then.
bool parallel(int threads, int count, const std::function<bool(int)>& work);

}  // namespace vamp::acquire
