#pragma once
// How long the device took between two points of a command list.
#include <vulkan/vulkan.h>

#include <cstdint>
#include <memory>

namespace vamp::gpu {

class Device;
struct QueryState;

// A few slots; each is written by CommandList::timestamp at most once per list and read when the list is done.
class Timestamps {
 public:
  Timestamps() = default;
  // At most 64 slots.
  Timestamps(Device& device, uint32_t slots);

  // Milliseconds between two slots, negative when either has not been written yet or the device has no timestamps.
  double milliseconds(uint32_t from, uint32_t to) const;

  const std::shared_ptr<QueryState>& state() const { return state_; }

  Timestamps(Timestamps&&) noexcept = default;
  Timestamps& operator=(Timestamps&&) noexcept = default;

 private:
  std::shared_ptr<QueryState> state_;
};

}  // namespace vamp::gpu
