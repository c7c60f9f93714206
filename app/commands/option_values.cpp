#include "app/commands/option_values.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace vamp {
namespace {

template <class T>
bool read_whole(std::string_view text, T& value) {
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  return code == std::errc() && end == text.data() + text.size();
}

std::string quoted(std::string_view text) { return fmt::format("\"{}\"", text.substr(0, 80)); }

}  // namespace

Result<float> number_option(std::string_view text, std::string_view option, float low, float high) {
  float value = 0;
  if (read_whole(text, value) && value >= low && value <= high) return value;
  return fail(ErrorKind::usage, "", option, fmt::format("a number from {:g} to {:g}", low, high), quoted(text));
}

Result<uint32_t> count_option(std::string_view text, std::string_view option, uint32_t low, uint32_t high) {
  uint32_t value = 0;
  if (read_whole(text, value) && value >= low && value <= high) return value;
  return fail(ErrorKind::usage, "", option, fmt::format("a whole number from {} to {}", low, high), quoted(text));
}

Result<vec3> vector_option(std::string_view text, std::string_view option, float low, float high) {
  const std::vector<std::string_view> pieces = list_option(text);
  vec3 value(0);
  bool good = pieces.size() == 3;
  for (int i = 0; good && i < 3; ++i)
    good = read_whole(pieces[static_cast<size_t>(i)], value[i]) && value[i] >= low && value[i] <= high;
  if (good) return value;
  return fail(ErrorKind::usage, "", option, fmt::format("x,y,z, each from {:g} to {:g}", low, high), quoted(text));
}

std::vector<std::string_view> list_option(std::string_view text) {
  std::vector<std::string_view> pieces;
  if (text.empty()) return pieces;
  for (size_t begin = 0;;) {
    const size_t end = text.find(',', begin);
    pieces.push_back(text.substr(begin, end - begin));
    if (end == std::string_view::npos) return pieces;
    begin = end + 1;
  }
}

Result<std::pair<std::string_view, std::string_view>> pair_option(std::string_view text, std::string_view option) {
  const size_t equals = text.find('=');
  if (equals == std::string_view::npos || equals == 0 || equals + 1 == text.size())
    return fail(ErrorKind::usage, "", option, "PART=VALUE", quoted(text));
  return std::pair(text.substr(0, equals), text.substr(equals + 1));
}

}  // namespace vamp
