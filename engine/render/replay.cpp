#include "engine/render/replay.h"

#include <algorithm>
#include <numeric>

#include "engine/core/check.h"

namespace vamp {

void Replay::begin(std::vector<uint32_t> pixels, std::span<const uint32_t> targets) {
  CHECK(pixels.size() == targets.size());
  clear();
  // A stable sort keeps neighbours together, who read the same tables.
  std::vector<uint32_t> order(pixels.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return targets[a] > targets[b]; });
  for (const uint32_t i : order) {
    CHECK(targets[i] > 0);
    pixels_.push_back(pixels[i]);
    if (groups_.empty() || groups_.back().target != targets[i]) groups_.push_back({targets[i], 0});
    groups_.back().end = static_cast<uint32_t>(pixels_.size());
  }
}

Replay::Step Replay::step() const {
  Step step;
  for (const Group& group : groups_)
    if (group.target > done_) step = {group.end, group.target};
  return step;
}

void Replay::advance(uint32_t batch) {
  done_ += batch;
  if (step().pixels == 0) clear();
}

}  // namespace vamp
