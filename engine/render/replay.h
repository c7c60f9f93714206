#pragma once
// Pixels whose samples are shaded again, from the first one, after an edit that moved no ray.
#include <cstdint>
#include <span>
#include <vector>

namespace vamp {

class Replay {
 public:
  // So many of the list's first pixels want samples [done, done + batch).
  struct Step {
    uint32_t pixels = 0;
    uint32_t limit = 0;  // all of them want at least up to here
  };

  // Begins anew with pixels of which each has a number of samples to come back to, at least 1.
  void begin(std::vector<uint32_t> pixels, std::span<const uint32_t> targets);
  void clear() { *this = {}; }

  bool active() const { return !pixels_.empty(); }
  // Those with the most samples first.
  const std::vector<uint32_t>& pixels() const { return pixels_; }
  uint32_t done() const { return done_; }
  Step step() const;
  // All pixels of the step have its batch: on to the next; inactive after the last.
  void advance(uint32_t batch);

 private:
  struct Group {
    uint32_t target = 0;
    uint32_t end = 0;  // of its pixels in the list
  };
  std::vector<uint32_t> pixels_;
  std::vector<Group> groups_;
  uint32_t done_ = 0;
};

}  // namespace vamp
