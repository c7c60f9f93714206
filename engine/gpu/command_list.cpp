#include "engine/gpu/command_list.h"

#include <algorithm>
#include <utility>

#include "engine/core/check.h"
#include "engine/gpu/device.h"
#include "engine/gpu/pipeline_state.h"
#include "engine/gpu/timestamps.h"
#include "engine/gpu/timestamps_state.h"

namespace vamp::gpu {
namespace {

struct Scope {
  VkPipelineStageFlags stages = 0;
  VkAccessFlags reads = 0;
  VkAccessFlags writes = 0;
};

Scope scope_of(Stage stage) {
  const auto in = [stage](Stage s) { return (static_cast<uint32_t>(stage) & static_cast<uint32_t>(s)) != 0; };
  Scope scope;
  if (in(Stage::compute)) {
    scope.stages |= VK_PIPELINE_STAGE_COMPUTE_SHADER_BIT;
    scope.reads |= VK_ACCESS_SHADER_READ_BIT | VK_ACCESS_UNIFORM_READ_BIT;
    scope.writes |= VK_ACCESS_SHADER_WRITE_BIT;
  }
  if (in(Stage::transfer)) {
    scope.stages |= VK_PIPELINE_STAGE_TRANSFER_BIT;
    scope.reads |= VK_ACCESS_TRANSFER_READ_BIT;
    scope.writes |= VK_ACCESS_TRANSFER_WRITE_BIT;
  }
  if (in(Stage::indirect)) {
    scope.stages |= VK_PIPELINE_STAGE_DRAW_INDIRECT_BIT;
    scope.reads |= VK_ACCESS_INDIRECT_COMMAND_READ_BIT;
  }
  if (in(Stage::graphics)) {
    scope.stages |= VK_PIPELINE_STAGE_ALL_GRAPHICS_BIT;
    scope.reads |= VK_ACCESS_MEMORY_READ_BIT;
    scope.writes |= VK_ACCESS_MEMORY_WRITE_BIT;
  }
  return scope;
}

}  // namespace

CommandList::CommandList(CommandList&& other) noexcept { *this = std::move(other); }

CommandList& CommandList::operator=(CommandList&& other) noexcept {
  if (this == &other) return *this;
  release();
  device_ = std::exchange(other.device_, nullptr);
  commands_ = std::exchange(other.commands_, {});
  kept_ = std::move(other.kept_);
  bound_ = std::exchange(other.bound_, nullptr);
  return *this;
}

CommandList::~CommandList() { release(); }

void CommandList::release() {
  if (device_ && commands_.pool) device_->recycle(commands_);
  device_ = nullptr;
  commands_ = {};
  kept_.clear();
}

void CommandList::keep(const std::shared_ptr<Resource>& resource) {
  if (std::find(kept_.begin(), kept_.end(), resource) == kept_.end()) kept_.push_back(resource);
}

void CommandList::use(const Buffer& buffer) {
  CHECK(buffer);
  keep(buffer.state());
}

void CommandList::bind(const ComputePipeline& pipeline, const DescriptorSet& set) {
  CHECK(device_ && pipeline && set);
  CHECK(pipeline.state()->set_layout == set.state()->layout);
  keep(pipeline.state());
  keep(set.state());
  bound_ = pipeline.state().get();
  const VkDescriptorSet sets[] = {set.handle()};
  vkCmdBindPipeline(handle(), VK_PIPELINE_BIND_POINT_COMPUTE, pipeline.handle());
  vkCmdBindDescriptorSets(handle(), VK_PIPELINE_BIND_POINT_COMPUTE, pipeline.layout(), 0, 1, sets, 0, nullptr);
}

void CommandList::push_bytes(const void* constants, uint32_t bytes) {
  CHECK(bound_ && bytes == bound_->push_bytes);
  vkCmdPushConstants(handle(), bound_->layout, VK_SHADER_STAGE_COMPUTE_BIT, 0, bytes, constants);
}

void CommandList::dispatch(uint32_t groups_x, uint32_t groups_y, uint32_t groups_z) {
  CHECK(bound_);
  const auto& limits = device_->info().max_group_count;
  CHECK(groups_x <= limits[0] && groups_y <= limits[1] && groups_z <= limits[2]);
  if (groups_x == 0 || groups_y == 0 || groups_z == 0) return;
  vkCmdDispatch(handle(), groups_x, groups_y, groups_z);
}

void CommandList::dispatch_indirect(const Buffer& arguments, uint64_t offset) {
  CHECK(bound_ && has(arguments.usage(), Usage::indirect) && offset % 4 == 0 && offset + 12 <= arguments.bytes());
  use(arguments);
  vkCmdDispatchIndirect(handle(), arguments.handle(), offset);
}

void CommandList::copy(const Buffer& from, uint64_t from_offset, const Buffer& to, uint64_t to_offset, uint64_t bytes) {
  CHECK(device_ && from_offset <= from.bytes() && bytes <= from.bytes() - from_offset);
  CHECK(to_offset <= to.bytes() && bytes <= to.bytes() - to_offset);
  if (bytes == 0) return;
  use(from);
  use(to);
  const VkBufferCopy region{from_offset, to_offset, bytes};
  vkCmdCopyBuffer(handle(), from.handle(), to.handle(), 1, &region);
}

void CommandList::fill(const Buffer& buffer, uint32_t value, uint64_t offset, uint64_t bytes) {
  CHECK(device_ && offset % 4 == 0 && offset <= buffer.bytes());
  const uint64_t rest = buffer.bytes() - offset;
  const bool to_end = bytes == VK_WHOLE_SIZE || bytes == rest;
  CHECK(to_end || (bytes <= rest && bytes % 4 == 0));
  if ((to_end ? rest : bytes) == 0) return;
  use(buffer);
  // Buffers are allocated in whole rows of 16 bytes, so the end may be rounded up to whole words.
  vkCmdFillBuffer(handle(), buffer.handle(), offset, to_end ? (rest + 3) / 4 * 4 : bytes, value);
}

void CommandList::barrier(Stage from, Stage to) {
  CHECK(device_);
  const Scope source = scope_of(from), target = scope_of(to);
  const VkMemoryBarrier memory{.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER,
                               .srcAccessMask = source.writes,
                               .dstAccessMask = target.reads | target.writes};
  vkCmdPipelineBarrier(handle(), source.stages, target.stages, 0, 1, &memory, 0, nullptr, 0, nullptr);
}

void CommandList::timestamp(Timestamps& timestamps, uint32_t slot) {
  const auto& state = timestamps.state();
  CHECK(device_ && state && slot < state->slots);
  if (!state->pool) return;
  keep(state);
  vkCmdResetQueryPool(handle(), state->pool, slot, 1);
  vkCmdWriteTimestamp(handle(), VK_PIPELINE_STAGE_BOTTOM_OF_PIPE_BIT, state->pool, slot);
  state->written.fetch_or(uint64_t{1} << slot);
}

}  // namespace vamp::gpu
