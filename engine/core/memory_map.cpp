#include "engine/core/memory_map.h"

#include <fcntl.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <limits>
#include <string>
#include <utility>

#include "engine/core/check.h"

namespace vamp {
namespace {

// A descriptor for the length of a function: maps outlive it.
struct Descriptor {
  explicit Descriptor(int number) : fd(number) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (fd >= 0) ::close(fd);
  }
  int fd;
};

tl::unexpected<Error> io_error(const fs::path& path, const char* what, int code) {
  return fail(ErrorKind::io, path.string(), "", std::string(what) + ": " + std::strerror(code));
}

}  // namespace

MemoryMap::MemoryMap(MemoryMap&& other) noexcept
    : data_(std::exchange(other.data_, nullptr)),
      size_(std::exchange(other.size_, 0)),
      writable_(other.writable_),
      has_file_(other.has_file_) {}

MemoryMap& MemoryMap::operator=(MemoryMap&& other) noexcept {
  MemoryMap taken(std::move(other));
  std::swap(data_, taken.data_);
  std::swap(size_, taken.size_);
  std::swap(writable_, taken.writable_);
  std::swap(has_file_, taken.has_file_);
  return *this;
}

MemoryMap::~MemoryMap() {
  if (data_ != nullptr) ::munmap(data_, size_);
}

Result<MemoryMap> MemoryMap::open(const fs::path& path, MapAccess access) {
  const bool write = access == MapAccess::read_write;
  // Without O_NONBLOCK a pipe would wait for its other end.
  const Descriptor file(::open(path.c_str(), (write ? O_RDWR : O_RDONLY) | O_CLOEXEC | O_NONBLOCK));
  if (file.fd < 0 && errno == ENOENT) return fail(ErrorKind::bad_input, path.string(), "", "a file", "nothing there");
  if (file.fd < 0 && errno == EISDIR) return fail(ErrorKind::bad_input, path.string(), "", "a file", "a folder");
  if (file.fd < 0) return io_error(path, "cannot be opened", errno);
  struct stat about {};
  if (::fstat(file.fd, &about) != 0) return io_error(path, "cannot be opened", errno);
  if (S_ISDIR(about.st_mode)) return fail(ErrorKind::bad_input, path.string(), "", "a file", "a folder");
  if (!S_ISREG(about.st_mode)) return fail(ErrorKind::bad_input, path.string(), "", "a file", "a device or a pipe");
  if (about.st_size == 0) return fail(ErrorKind::bad_input, path.string(), "", "a file with content", "an empty file");
  const auto size = static_cast<size_t>(about.st_size);
  void* data = ::mmap(nullptr, size, write ? PROT_READ | PROT_WRITE : PROT_READ, MAP_SHARED, file.fd, 0);
  if (data == MAP_FAILED) return io_error(path, "cannot be mapped", errno);
  return MemoryMap(static_cast<std::byte*>(data), size, write, true);
}

Result<MemoryMap> MemoryMap::create(const fs::path& path, uint64_t bytes) {
  CHECK(bytes > 0 && bytes <= uint64_t{std::numeric_limits<off_t>::max()});
  // An old file is unlinked, not emptied: it may be mapped just now, as the input of what is written here.
  struct stat old {};
  if (::lstat(path.c_str(), &old) == 0) {
    if (!S_ISREG(old.st_mode))
      return fail(ErrorKind::io, path.string(), "", "cannot be written: it is no regular file");
    if (::unlink(path.c_str()) != 0) return io_error(path, "cannot be written", errno);
  }
  const Descriptor file(::open(path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666));
  if (file.fd < 0) return io_error(path, "cannot be written", errno);
  int code = ::posix_fallocate(file.fd, 0, static_cast<off_t>(bytes));
  void* data = MAP_FAILED;
  if (code == 0) {
    data = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_SHARED, file.fd, 0);
    if (data == MAP_FAILED) code = errno;
  }
  if (code != 0) {
    ::unlink(path.c_str());
    return io_error(path, "cannot be written", code);
  }
  return MemoryMap(static_cast<std::byte*>(data), bytes, true, true);
}

Result<MemoryMap> MemoryMap::in_memory(uint64_t bytes) {
  CHECK(bytes > 0);
  void* data = ::mmap(nullptr, bytes, PROT_READ | PROT_WRITE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0);
  if (data == MAP_FAILED)
    return fail(ErrorKind::failed, "", "memory", std::to_string(bytes >> 20) + " MiB", std::strerror(errno));
  return MemoryMap(static_cast<std::byte*>(data), bytes, true, false);
}

std::span<std::byte> MemoryMap::writable() {
  CHECK(writable_);
  return {data_, size_};
}

Status MemoryMap::flush(const fs::path& path) const {
  if (has_file_ && writable_ && ::msync(data_, size_, MS_SYNC) != 0) return io_error(path, "cannot be written", errno);
  return {};
}

void MemoryMap::forget(uint64_t offset, uint64_t count) const {
  if (!has_file_ || offset >= size_) return;
  // Whole pages. The one before the range goes too, so that a pass in pieces lets go of all; the one behind comes next.
  const auto page = static_cast<uint64_t>(::sysconf(_SC_PAGESIZE));
  const uint64_t end = offset + std::min<uint64_t>(count, size_ - offset);
  const uint64_t first = offset / page * page;
  const uint64_t last = end == size_ ? end : end / page * page;
  if (first < last) ::madvise(data_ + first, last - first, MADV_DONTNEED);
}

}  // namespace vamp
