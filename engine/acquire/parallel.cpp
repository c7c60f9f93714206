#include "engine/acquire/parallel.h"

#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

namespace vamp::acquire {

bool parallel(int threads, int count, const std::function<bool(int)>& work) {
  if (threads == 0) threads = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  std::atomic<int> next{0};
  std::atomic<bool> going{true};
  const auto loop = [&] {
    for (int i = next++; i < count && going; i = next++)
      if (!work(i)) going = false;
  };
  std::vector<std::jthread> others;
  for (int i = 1; i < std::min(threads, count); ++i) others.emplace_back(loop);
  loop();
  others.clear();
  return going;
}

}  // namespace vamp::acquire
