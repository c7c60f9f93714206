#include "engine/core/files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <utility>

namespace vamp {
namespace {

std::string system_reason() { return std::strerror(errno); }

template <class Container>
Result<Container> read_whole(const fs::path& path, uint64_t limit) {
  std::error_code code;
  const auto status = fs::status(path, code);
  if (status.type() == fs::file_type::not_found)
    return fail(ErrorKind::bad_input, path.string(), "", "a file", "nothing there");
  if (!fs::status_known(status)) return fail(ErrorKind::io, path.string(), "", "cannot be opened: " + code.message());
  if (fs::is_directory(status)) return fail(ErrorKind::bad_input, path.string(), "", "a file", "a folder");
  std::ifstream stream(path, std::ios::binary);
  if (!stream) return fail(ErrorKind::io, path.string(), "", "cannot be opened: " + system_reason());
  // Read in pieces rather than trust the size that the file system reports: /dev/zero has none.
  Container content;
  char piece[1 << 16];
  while (stream) {
    stream.read(piece, sizeof(piece));
    const auto count = static_cast<size_t>(stream.gcount());
    if (content.size() + count > limit)
      return fail(ErrorKind::bad_input, path.string(), "size", "at most " + std::to_string(limit) + " bytes", "more");
    const size_t old = content.size();
    content.resize(old + count);
    if (count > 0) std::memcpy(content.data() + old, piece, count);
  }
  if (stream.bad()) return fail(ErrorKind::io, path.string(), "", "cannot be read: " + system_reason());
  return content;
}

fs::path xdg(const char* variable, const char* fallback_below_home) {
  const char* value = std::getenv(variable);
  if (value != nullptr && value[0] == '/') return fs::path(value) / "vamp";
  const char* home = std::getenv("HOME");
  return fs::path(home != nullptr && home[0] == '/' ? home : "/tmp") / fallback_below_home / "vamp";
}

// A file descriptor that closes itself.
class Descriptor {
 public:
  explicit Descriptor(int fd) : fd_(fd) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (fd_ >= 0) ::close(fd_);
  }
  int get() const { return fd_; }
  int close_now() { return ::close(std::exchange(fd_, -1)); }

 private:
  int fd_;
};

bool write_all(int fd, std::span<const std::byte> bytes) {
  for (size_t done = 0; done < bytes.size();) {
    const ssize_t count = ::write(fd, bytes.data() + done, bytes.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count == 0) errno = EIO;
    if (count <= 0) return false;
    done += static_cast<size_t>(count);
  }
  return true;
}

// Creates a new file in `folder` and says its path; -1 and errno when that fails. Its name does not depend on the
// target's, which may already be as long as names can be; its mode is what the user's umask lets files be.
int create_beside(const fs::path& folder, fs::path& path) {
  static std::atomic<unsigned> counter{0};
  for (int attempt = 0; attempt < 1000; ++attempt) {
    path = folder / (".vamp-" + std::to_string(::getpid()) + "-" + std::to_string(counter++) + ".tmp");
    const int fd = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
    if (fd >= 0 || errno != EEXIST) return fd;
  }
  return -1;
}

}  // namespace

Result<std::vector<std::byte>> read_file(const fs::path& path, uint64_t limit) {
  return read_whole<std::vector<std::byte>>(path, limit);
}

Result<std::string> read_text(const fs::path& path, uint64_t limit) { return read_whole<std::string>(path, limit); }

Status write_file_atomically(const fs::path& path, std::span<const std::byte> bytes) {
  std::error_code code;
  // A symbolic link stays one: what it points to is replaced.
  const fs::path target = fs::is_symlink(path, code) ? fs::weakly_canonical(path, code) : path;
  const auto give_up = [&path](std::string_view reason) {
    return fail(ErrorKind::io, path.string(), "", "cannot be written: " + std::string(reason));
  };
  struct stat old {};
  const bool exists = ::stat(target.c_str(), &old) == 0;
  if (exists && S_ISDIR(old.st_mode)) return give_up("it is a folder");
  if (exists && ::access(target.c_str(), W_OK) != 0) return give_up(system_reason());
  if (exists && !S_ISREG(old.st_mode)) {
    // A device or a pipe is written to, never replaced by a file.
    Descriptor device(::open(target.c_str(), O_WRONLY | O_CLOEXEC));
    if (device.get() < 0 || !write_all(device.get(), bytes) || device.close_now() != 0) return give_up(system_reason());
    return {};
  }

  const fs::path folder = target.has_parent_path() ? target.parent_path() : fs::path(".");
  fs::path temporary;
  Descriptor file(create_beside(folder, temporary));
  if (file.get() < 0) return give_up(system_reason());
  // A file that was private, or open to a group, stays so.
  const bool done = write_all(file.get(), bytes) && (!exists || ::fchmod(file.get(), old.st_mode & 07777) == 0) &&
                    ::fsync(file.get()) == 0 && file.close_now() == 0 &&
                    ::rename(temporary.c_str(), target.c_str()) == 0;
  if (!done) {
    const std::string reason = system_reason();
    ::unlink(temporary.c_str());
    return give_up(reason);
  }
  Descriptor directory(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
  if (directory.get() >= 0) ::fsync(directory.get());
  return {};
}

Status write_text_atomically(const fs::path& path, std::string_view text) {
  return write_file_atomically(path, std::as_bytes(std::span(text.data(), text.size())));
}

Result<fs::path> resolve_inside(const fs::path& base, std::string_view relative, std::string_view file,
                                std::string_view place) {
  const auto refuse = [&](std::string_view why) {
    return fail(ErrorKind::bad_input, file, place, why, "\"" + std::string(relative) + "\"");
  };
  const fs::path path(relative);
  if (relative.empty() || relative.find('\0') != std::string_view::npos) return refuse("a file name");
  if (path.is_absolute() || relative.find("://") != std::string_view::npos ||
      relative.find('\\') != std::string_view::npos)
    return refuse("a path relative to the file's folder");
  for (const auto& step : path)
    if (step == "..") return refuse("a path inside the file's folder");
  std::error_code code;
  const fs::path root = fs::weakly_canonical(base.empty() ? fs::path(".") : base, code);
  if (code) return refuse("a path inside the file's folder");
  const fs::path full = fs::weakly_canonical(root / path, code);
  const auto [root_end, unused] = std::mismatch(root.begin(), root.end(), full.begin(), full.end());
  if (code || root_end != root.end()) return refuse("a path inside the file's folder");
  return full;
}

fs::path config_dir() { return xdg("XDG_CONFIG_HOME", ".config"); }
fs::path state_dir() { return xdg("XDG_STATE_HOME", ".local/state"); }
fs::path data_dir() { return xdg("XDG_DATA_HOME", ".local/share"); }
fs::path cache_dir() { return xdg("XDG_CACHE_HOME", ".cache"); }

fs::path shipped_dir(std::string_view name) {
  std::error_code code;
  if (const char* root = std::getenv("VAMP_DATA"); root != nullptr && fs::is_directory(fs::path(root) / name, code))
    return fs::path(root) / name;
  // build/<preset>/vamp inside a checkout, or bin/vamp beside share/vamp when installed.
  const fs::path executable = fs::read_symlink("/proc/self/exe", code);
  for (fs::path folder = executable.parent_path(); !folder.empty(); folder = folder.parent_path()) {
    for (const fs::path& candidate : {folder / name, folder / "share" / "vamp" / name})
      if (fs::is_directory(candidate, code)) return candidate;
    if (folder == folder.root_path()) break;
  }
  return {};
}

}  // namespace vamp
