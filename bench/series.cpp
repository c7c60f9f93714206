#include "bench/series.h"

#include <fmt/format.h>

#include <thread>

namespace vamp {

unsigned processors() { return std::max(std::thread::hardware_concurrency(), 1u); }

Times Stopwatch::stop() const {
  const double cpu = static_cast<double>(std::clock() - cpu_) / CLOCKS_PER_SEC;
  return {1e3 * cpu / processors(), 1e3 * seconds_since(wall_)};
}

double quantile(std::vector<double> values, double q) {
  if (values.empty()) return 0;
  std::sort(values.begin(), values.end());
  return values[static_cast<size_t>(q * static_cast<double>(values.size() - 1) + 0.5)];
}

void Series::add(Times times, double share) {
  cpu_.push_back(times.cpu_ms * share);
  wall_.push_back(times.wall_ms * share);
}

std::string Series::text() const {
  return fmt::format("{:.1f} ms ({:.1f} to {:.1f}; wall {:.1f})", cpu(), cpu(0.1), cpu(0.9), wall());
}

Json Series::json() const { return Json{{"ms", cpu()}, {"ms_10", cpu(0.1)}, {"ms_90", cpu(0.9)}, {"wall_ms", wall()}}; }

}  // namespace vamp
