#pragma once
// What Timestamps owns.
#include <atomic>

#include "engine/gpu/resource.h"

namespace vamp::gpu {

struct QueryState final : Resource {
  using Resource::Resource;
  ~QueryState() override;
  void mark_used(uint64_t) override {}

  VkQueryPool pool = VK_NULL_HANDLE;
  uint32_t slots = 0;
  std::atomic<uint64_t> written = 0;  // a bit a slot: only those may be asked for
};

}  // namespace vamp::gpu
