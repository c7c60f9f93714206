#pragma once
// What every measurement of the benchmarks is told as: a median with its spread, in both clocks.
#include <algorithm>
#include <cmath>
#include <ctime>
#include <span>
#include <string>
#include <vector>

#include "engine/core/clock.h"
#include "engine/core/json.h"

namespace vamp {

// Processors that the program may use, at least 1.
unsigned processors();

// Processor time of all threads over the number of processors, which is what a job would take on an otherwise idle
// machine that it fills, and wall time.
struct Times {
  double cpu_ms = 0, wall_ms = 0;
};

// Runs from the moment it is made.
class Stopwatch {
 public:
  Times stop() const;

 private:
  std::clock_t cpu_ = std::clock();
  Clock::time_point wall_ = Clock::now();
};

// The value below which the share `q` of `values` lies, 0 <= q <= 1; 0 of none.
double quantile(std::vector<double> values, double q);

// Times of one thing in several rounds.
class Series {
 public:
  // `share`: what part of the time belongs to the thing, 0.25 for one of four samples.
  void add(Times times, double share = 1);
  double cpu(double q = 0.5) const { return quantile(cpu_, q); }
  double wall(double q = 0.5) const { return quantile(wall_, q); }
  // "129.0 ms (116.0 to 133.0; wall 140.2)": median, tenth and ninetieth percentile of processor time.
  std::string text() const;
  // {"ms", "ms_10", "ms_90", "wall_ms"}.
  Json json() const;

 private:
  std::vector<double> cpu_, wall_;
};

}  // namespace vamp
