#include "app/commands/text_output.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <utility>

namespace vamp {

Result<TextOutput> TextOutput::open(const std::string& path) {
  TextOutput output;
  if (path == "-") {
    output.file_ = stdout;
    return output;
  }
  std::error_code code;
  output.path_ = fs::is_symlink(path, code) ? fs::weakly_canonical(path, code) : fs::path(path);
  const auto status = fs::status(output.path_, code);
  if (fs::is_directory(status)) return fail(ErrorKind::io, path, "", "a file", "a folder");
  if (fs::exists(status) && !fs::is_regular_file(status)) {
    // A device or a pipe is written to, never replaced by a file.
    output.file_ = std::fopen(path.c_str(), "wb");
  } else if (!fs::exists(status) || ::access(output.path_.c_str(), W_OK) == 0) {
    const fs::path folder = output.path_.has_parent_path() ? output.path_.parent_path() : fs::path(".");
    output.temporary_ = folder / (".vamp-" + std::to_string(::getpid()) + "-text.tmp");
    const int descriptor = ::open(output.temporary_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
    if (descriptor >= 0) output.file_ = ::fdopen(descriptor, "wb");
  } else {
    errno = EACCES;
  }
  if (!output.file_) return output.failed();
  return output;
}

TextOutput::TextOutput(TextOutput&& other) noexcept
    : file_(std::exchange(other.file_, nullptr)),
      path_(std::move(other.path_)),
      temporary_(std::exchange(other.temporary_, {})) {}

TextOutput::~TextOutput() {
  if (file_ && file_ != stdout) std::fclose(file_);
  if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

tl::unexpected<Error> TextOutput::failed() const {
  const std::string name = path_.empty() ? "standard output" : path_.string();
  return fail(ErrorKind::io, name, "", std::string("cannot be written: ") + std::strerror(errno));
}

Status TextOutput::write(std::string_view text) {
  if (std::fwrite(text.data(), 1, text.size(), file_) != text.size()) return failed();
  return {};
}

Status TextOutput::finish() {
  if (std::fflush(file_) != 0) return failed();
  if (file_ == stdout) return {};
  const bool regular = !temporary_.empty();
  if (regular && ::fsync(::fileno(file_)) != 0) return failed();
  if (std::fclose(std::exchange(file_, nullptr)) != 0) return failed();
  if (regular && ::rename(temporary_.c_str(), path_.c_str()) != 0) return failed();
  temporary_.clear();
  return {};
}

}  // namespace vamp
