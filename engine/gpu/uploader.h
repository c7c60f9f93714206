#pragma once
// The staging ring: host memory through which bytes reach buffers that the host cannot write or the device still uses.
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <span>
#include <vector>

#include "engine/gpu/buffer.h"
#include "engine/gpu/command_list.h"
#include "engine/gpu/resource.h"

namespace vamp::gpu {

class Device;

class Uploader {
 public:
  explicit Uploader(Device& device) : device_(device) {}

  void upload(const std::shared_ptr<BufferState>& to, uint64_t offset, std::span<const std::byte> bytes);

  // Records the copies that wait and appends what they use; the caller submits them as timeline value `value`, ahead of
  // anything else.
  void record(CommandList& list, uint64_t value);

  // Whether any copies wait for the next submit, or any into this buffer.
  bool any();
  bool waiting(const BufferState& buffer);

 private:
  struct Copy {
    std::shared_ptr<BufferState> to;
    uint64_t ring_offset = 0;
    uint64_t offset = 0;
    uint64_t bytes = 0;
    bool after_barrier = false;  // overlaps an earlier copy, which must be done first
  };
  struct Segment {
    uint64_t value = 0;  // free when this timeline value is reached
    uint64_t end = 0;    // head of the ring then
  };
  bool take(uint64_t bytes, uint64_t& ring_offset);
  bool overlaps(const BufferState& to, uint64_t offset, uint64_t bytes) const;

  Device& device_;
  std::mutex mutex_;
  Buffer ring_;
  // Positions grow without end; modulo the ring's size they are offsets. head - tail is in use.
  uint64_t head_ = 0;
  uint64_t tail_ = 0;
  std::deque<Segment> segments_;
  std::vector<Copy> copies_;
  size_t barrier_at_ = 0;  // copies before this one are behind the last barrier
};

}  // namespace vamp::gpu
