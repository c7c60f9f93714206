#include "engine/core/error.h"

namespace vamp {

std::string Error::message() const {
  std::string text = file;
  const auto append = [&text](std::string_view joint, const std::string& part) {
    if (part.empty()) return;
    if (!text.empty()) text += joint;
    text += part;
  };
  append(": ", place);
  if (!expected.empty()) append(": ", found.empty() ? expected : "expected " + expected);
  append(", found ", found);
  // One line, whatever stands in file names and damaged files.
  for (char& c : text)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  return text;
}

tl::unexpected<Error> fail(ErrorKind kind, std::string_view file, std::string_view place, std::string_view expected,
                           std::string_view found) {
  return tl::unexpected(Error{kind, std::string(file), std::string(place), std::string(expected), std::string(found)});
}

}  // namespace vamp
