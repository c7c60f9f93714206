#include "bench/temporary_folder.h"

#include <stdlib.h>

#include <utility>

namespace vamp {

Result<TemporaryFolder> TemporaryFolder::make() {
  std::error_code code;
  std::string name = (fs::temp_directory_path(code) / "vamp-bench-XXXXXX").string();
  if (::mkdtemp(name.data()) == nullptr)
    return fail(ErrorKind::io, name, "", "a temporary folder", "none could be made");
  return TemporaryFolder(name);
}

TemporaryFolder::TemporaryFolder(TemporaryFolder&& other) noexcept : path_(std::exchange(other.path_, {})) {}

TemporaryFolder& TemporaryFolder::operator=(TemporaryFolder&& other) noexcept {
  std::swap(path_, other.path_);
  return *this;
}

TemporaryFolder::~TemporaryFolder() {
  std::error_code code;
  if (!path_.empty()) fs::remove_all(path_, code);
}

}  // namespace vamp
