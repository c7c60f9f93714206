#include "engine/fit/parallel.h"

#include <algorithm>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace vamp::fit {

void Worker::stage(const std::string& label) const {
  if (progress == nullptr) return;
  progress->stage(label);
  progress->fraction(0);
}

void Worker::done(int part, int of) const {
  if (progress != nullptr) progress->fraction(static_cast<float>(part) / static_cast<float>(of));
}

void Worker::each(size_t count, const std::function<void(size_t)>& work) const {
  std::atomic<size_t> next{0};
  std::exception_ptr failure;
  std::mutex mutex;
  const auto loop = [&] {
    try {
      for (size_t i = next++; i < count && !cancelled(); i = next++) {
        work(i);
        if (progress != nullptr) progress->fraction(static_cast<float>(i + 1) / static_cast<float>(count));
      }
    } catch (...) {
      const std::lock_guard lock(mutex);
      failure = std::current_exception();
      next = count;
    }
  };
  std::vector<std::thread> others;
  const size_t wanted = std::min(count, static_cast<size_t>(std::max(threads, 1)));
  for (size_t i = 1; i < wanted; ++i) others.emplace_back(loop);
  loop();
  for (std::thread& thread : others) thread.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace vamp::fit
