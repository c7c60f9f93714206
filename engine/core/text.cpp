#include "engine/core/text.h"

namespace vamp {

std::string lower(std::string_view text) {
  std::string small(text);
  // Not std::tolower, whose answer hangs on the locale.
  for (char& c : small)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return small;
}

std::string lower_extension(const std::filesystem::path& path) { return lower(path.extension().string()); }

}  // namespace vamp
