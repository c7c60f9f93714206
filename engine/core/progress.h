#pragma once
// Long work says how far it is and asks whether to stop; anyone may read it from another thread.
#include <atomic>
#include <mutex>
#include <string>
#include <utility>

namespace vamp {

class Progress {
 public:
  void stage(std::string label) {
    const std::lock_guard lock(mutex_);
    label_ = std::move(label);
  }
  std::string stage() const {
    const std::lock_guard lock(mutex_);
    return label_;
  }
  void fraction(float done) { fraction_.store(done, std::memory_order_relaxed); }
  float fraction() const { return fraction_.load(std::memory_order_relaxed); }
  void cancel() { cancelled_.store(true, std::memory_order_relaxed); }
  bool cancelled() const { return cancelled_.load(std::memory_order_relaxed); }

 private:
  mutable std::mutex mutex_;
  std::string label_;
  std::atomic<float> fraction_{0};
  std::atomic<bool> cancelled_{false};
};

}  // namespace vamp
