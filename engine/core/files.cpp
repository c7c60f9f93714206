#include "engine/core/files.h"

#include <fcntl.h>
#include <unistd.h>

#include <sys/stat.h>

#include <algorithm>
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
  if (!fs::exists(status)) return fail(ErrorKind::bad_input, path.string(), "", "a file", "nothing there");
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

}  // namespace

Result<std::vector<std::byte>> read_file(const fs::path& path, uint64_t limit) {
  return read_whole<std::vector<std::byte>>(path, limit);
}

Result<std::string> read_text(const fs::path& path, uint64_t limit) { return read_whole<std::string>(path, limit); }

Status write_file_atomically(const fs::path& path, std::span<const std::byte> bytes) {
  const fs::path folder = path.has_parent_path() ? path.parent_path() : fs::path(".");
  std::string temporary = (folder / ("." + path.filename().string() + ".XXXXXX")).string();
  Descriptor file(::mkstemp(temporary.data()));
  if (file.get() < 0) return fail(ErrorKind::io, path.string(), "", "cannot be written: " + system_reason());
  const auto give_up = [&] {
    Status status = fail(ErrorKind::io, path.string(), "", "cannot be written: " + system_reason());
    ::unlink(temporary.c_str());
    return status;
  };
  for (size_t done = 0; done < bytes.size();) {
    const ssize_t count = ::write(file.get(), bytes.data() + done, bytes.size() - done);
    if (count < 0 && errno == EINTR) continue;
    if (count <= 0) return give_up();
    done += static_cast<size_t>(count);
  }
  // mkstemp makes the file private; a saved document is as open as the user's umask lets files be.
  const mode_t mask = ::umask(0);
  ::umask(mask);
  if (::fchmod(file.get(), 0666 & ~mask) != 0 || ::fsync(file.get()) != 0 || file.close_now() != 0) return give_up();
  if (::rename(temporary.c_str(), path.c_str()) != 0) return give_up();
  Descriptor directory(::open(folder.c_str(), O_RDONLY | O_DIRECTORY));
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
  if (path.is_absolute() || relative.find("://") != std::string_view::npos || relative.find('\\') != std::string_view::npos)
    return refuse("a path relative to the file's folder");
  for (const auto& step : path)
    if (step == "..") return refuse("a path inside the file's folder");
  std::error_code code;
  const fs::path root = fs::weakly_canonical(base.empty() ? fs::path(".") : base, code);
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
