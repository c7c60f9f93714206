#pragma once
#include <cstdio>
#include <string>
#include <string_view>

#include "engine/core/error.h"
#include "engine/core/files.h"

namespace vamp {

// Text written as it comes: to standard output for "-", else to a file that replaces an old one only when it is whole.
class TextOutput {
 public:
  static Result<TextOutput> open(const std::string& path);
  TextOutput(TextOutput&& other) noexcept;
  ~TextOutput();  // without finish() nothing is left behind
  Status write(std::string_view text);
  Status finish();

 private:
  TextOutput() = default;
  tl::unexpected<Error> failed() const;
  std::FILE* file_ = nullptr;
  fs::path path_, temporary_;
};

}  // namespace vamp
