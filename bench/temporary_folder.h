#pragma once
// A folder for what a benchmark writes only to read it again; it goes with this.
#include "engine/core/error.h"
#include "engine/core/files.h"

namespace vamp {

class TemporaryFolder {
 public:
  // Errors: io, where the system's place for such folders takes none.
  static Result<TemporaryFolder> make();
  TemporaryFolder(TemporaryFolder&& other) noexcept;
  TemporaryFolder& operator=(TemporaryFolder&& other) noexcept;
  ~TemporaryFolder();

  const fs::path& path() const { return path_; }

 private:
  explicit TemporaryFolder(fs::path path) : path_(std::move(path)) {}
  fs::path path_;  // empty: moved away
};

}  // namespace vamp
