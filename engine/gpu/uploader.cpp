#include "engine/gpu/uploader.h"

#include <algorithm>
#include <cstring>

#include "engine/gpu/device.h"

namespace vamp::gpu {
namespace {

constexpr uint64_t kRingBytes = 8 << 20;
// Large uploads go in pieces, so that copying one overlaps with filling the next.
constexpr uint64_t kPieceBytes = kRingBytes / 4;
constexpr uint64_t kAlignment = 16;

}  // namespace

void Uploader::upload(const std::shared_ptr<BufferState>& to, uint64_t offset, std::span<const std::byte> bytes) {
  if (to->mapped) {
    std::unique_lock lock(mutex_);
    const bool idle = to->staged_copies == 0;
    lock.unlock();
    if (idle && device_.done(to->last_use.load(std::memory_order_acquire))) {
      std::memcpy(to->mapped + offset, bytes.data(), bytes.size());
      return;
    }
  }
  while (!bytes.empty()) {
    const auto piece = bytes.first(std::min<size_t>(bytes.size(), kPieceBytes));
    std::unique_lock lock(mutex_);
    if (!ring_) ring_ = Buffer(device_, {"staging ring", kRingBytes, Usage::none, Memory::upload});
    uint64_t ring_offset = 0;
    if (!take(piece.size(), ring_offset)) {
      // The ring is full: send what waits, then wait for the oldest piece to be copied.
      const bool unsent = !copies_.empty();
      const uint64_t oldest = segments_.empty() ? 0 : segments_.front().value;
      lock.unlock();
      const uint64_t sent = unsent ? device_.submit(device_.begin("staged uploads")) : 0;
      device_.wait(oldest ? oldest : sent);
      continue;
    }
    std::memcpy(ring_.mapped() + ring_offset, piece.data(), piece.size());
    const bool again = overlaps(*to, offset, piece.size());
    if (again) barrier_at_ = copies_.size();
    copies_.push_back({to, ring_offset, offset, piece.size(), again});
    ++to->staged_copies;
    offset += piece.size();
    bytes = bytes.subspan(piece.size());
  }
}

bool Uploader::take(uint64_t bytes, uint64_t& ring_offset) {
  while (!segments_.empty() && device_.done(segments_.front().value)) {
    tail_ = segments_.front().end;
    segments_.pop_front();
  }
  const uint64_t size = (bytes + kAlignment - 1) / kAlignment * kAlignment;
  // A piece lies in one stretch: skip the rest of the ring when it is too short.
  const uint64_t rest = kRingBytes - head_ % kRingBytes;
  const uint64_t start = rest < size ? head_ + rest : head_;
  if (start + size - tail_ > kRingBytes) return false;
  ring_offset = start % kRingBytes;
  head_ = start + size;
  return true;
}

bool Uploader::overlaps(const BufferState& to, uint64_t offset, uint64_t bytes) const {
  return std::any_of(copies_.begin() + static_cast<ptrdiff_t>(barrier_at_), copies_.end(), [&](const Copy& copy) {
    return copy.to.get() == &to && copy.offset < offset + bytes && offset < copy.offset + copy.bytes;
  });
}

void Uploader::record(CommandList& list, uint64_t value) {
  const std::scoped_lock lock(mutex_);
  list.keep(ring_.state());
  for (const Copy& copy : copies_) {
    if (copy.after_barrier) list.barrier(Stage::transfer, Stage::transfer);
    list.keep(copy.to);
    const VkBufferCopy region{copy.ring_offset, copy.offset, copy.bytes};
    vkCmdCopyBuffer(list.handle(), ring_.handle(), copy.to->buffer, 1, &region);
    --copy.to->staged_copies;
  }
  copies_.clear();
  barrier_at_ = 0;
  segments_.push_back({value, head_});
}

bool Uploader::any() {
  const std::scoped_lock lock(mutex_);
  return !copies_.empty();
}

bool Uploader::waiting(const BufferState& buffer) {
  const std::scoped_lock lock(mutex_);
  return buffer.staged_copies > 0;
}

}  // namespace vamp::gpu
