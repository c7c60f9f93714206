#include "engine/gpu/timestamps.h"

#include "engine/core/check.h"
#include "engine/gpu/device.h"
#include "engine/gpu/machine.h"
#include "engine/gpu/timestamps_state.h"

namespace vamp::gpu {

QueryState::~QueryState() { vkDestroyQueryPool(device.handle(), pool, nullptr); }

Timestamps::Timestamps(Device& device, uint32_t slots) {
  CHECK(slots > 0 && slots <= 64);
  auto state = std::make_shared<QueryState>(device);
  state->slots = slots;
  const VkQueryPoolCreateInfo info{
      .sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO, .queryType = VK_QUERY_TYPE_TIMESTAMP, .queryCount = slots};
  if (device.info().timestamp_ns > 0)
    require(vkCreateQueryPool(device.handle(), &info, nullptr, &state->pool), "GPU timestamps");
  state_ = std::move(state);
}

double Timestamps::milliseconds(uint32_t from, uint32_t to) const {
  CHECK(state_ && from < state_->slots && to < state_->slots);
  const auto read = [this](uint32_t slot, uint64_t& ticks) {
    uint64_t answer[2] = {};  // ticks, then whether they are there
    if (!state_->pool || !(state_->written.load() >> slot & 1)) return false;
    const VkResult result =
        vkGetQueryPoolResults(state_->device.handle(), state_->pool, slot, 1, sizeof(answer), answer, sizeof(answer),
                              VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WITH_AVAILABILITY_BIT);
    ticks = answer[0];
    return result == VK_SUCCESS && answer[1] != 0;
  };
  uint64_t start = 0, end = 0;
  if (!read(from, start) || !read(to, end) || end < start) return -1.0;
  return static_cast<double>(end - start) * state_->device.info().timestamp_ns * 1e-6;
}

}  // namespace vamp::gpu
