#pragma once
// Bytes that lie in a file and are read and written as memory, or that lie in memory alone; larger than the machine's
// memory if need be.
#include <cstddef>
#include <cstdint>
#include <span>

#include "engine/core/files.h"

namespace vamp {

enum class MapAccess { read, read_write };

// Move-only; what was written reaches the file at the latest when the map goes away. Another program that shortens the
// file while it is mapped ends this one (SIGBUS): the system has no other answer.
class MemoryMap {
 public:
  MemoryMap() = default;
  MemoryMap(MemoryMap&& other) noexcept;
  MemoryMap& operator=(MemoryMap&& other) noexcept;
  ~MemoryMap();

  // An existing file, whole. bad_input: missing, empty or no regular file; io: cannot be opened or mapped.
  static Result<MemoryMap> open(const fs::path& path, MapAccess access);
  // A new file of zeros, or an old one replaced. Its room on the disk is taken at once, so that a full disk is an error
  // here and not a crash later. io when that fails; nothing is left behind then.
  static Result<MemoryMap> create(const fs::path& path, uint64_t bytes);
  // Zeros in memory; failed when the machine has not so much.
  static Result<MemoryMap> in_memory(uint64_t bytes);

  std::span<const std::byte> bytes() const { return {data_, size_}; }
  // Of a map that may be written: programming error otherwise.
  std::span<std::byte> writable();
  bool may_be_written() const { return writable_; }

  // Writes to the disk what is still on its way there.
  Status flush(const fs::path& path) const;
  // Gives back the memory that pages of this range take; they are read again when they are looked at again. Without
  // effect on maps that no file stands behind.
  void forget(uint64_t offset, uint64_t count) const;

 private:
  MemoryMap(std::byte* data, size_t size, bool writable, bool has_file)
      : data_(data), size_(size), writable_(writable), has_file_(has_file) {}
  std::byte* data_ = nullptr;
  size_t size_ = 0;
  bool writable_ = false;
  bool has_file_ = false;
};

}  // namespace vamp
