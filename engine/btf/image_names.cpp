#include "engine/btf/image_names.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <numbers>

namespace vamp {
namespace {

bool is_digit(char c) { return c >= '0' && c <= '9'; }

// The number behind the last `key` of the name that has one and is not the end of a longer word.
std::optional<double> number_after(std::string_view name, std::string_view key) {
  for (size_t at = name.rfind(key); at != std::string_view::npos; at = at == 0 ? name.npos : name.rfind(key, at - 1)) {
    const bool word_begins = at == 0 || !std::isalpha(static_cast<unsigned char>(name[at - 1]));
    const std::string_view rest = name.substr(at + key.size());
    if (!word_begins || rest.empty() || !is_digit(rest.front())) continue;
    size_t length = 0;
    while (length < rest.size() && is_digit(rest[length])) ++length;
    // A point belongs to the number only where a digit follows: ".jpg" does not.
    if (length + 1 < rest.size() && rest[length] == '.' && is_digit(rest[length + 1]))
      for (++length; length < rest.size() && is_digit(rest[length]);) ++length;
    double value = 0;
    if (std::from_chars(rest.data(), rest.data() + length, value).ec == std::errc()) return value;
  }
  return {};
}

// Degrees to four places behind the point at most, without zeros at their end.
std::string degrees(double radians) {
  const double value = std::round(radians * 180 / std::numbers::pi * 1e4) / 1e4;
  if (value == std::floor(value)) return fmt::format("{:03.0f}", value);
  std::string text = fmt::format("{:08.4f}", value);
  return text.substr(0, text.find_last_not_of('0') + 1);
}

}  // namespace

std::optional<ImageAngles> image_angles(std::string_view name) {
  const auto tl = number_after(name, "tl"), pl = number_after(name, "pl");
  const auto tv = number_after(name, "tv"), pv = number_after(name, "pv");
  if (!tl || !pl || !tv || !pv) return {};
  return ImageAngles{*tl, *pl, *tv, *pv};
}

std::string image_name(const dvec3& light, const dvec3& view) {
  const SphericalAngles l = angles_of(light), v = angles_of(view);
  return fmt::format("tl{}_pl{}_tv{}_pv{}", degrees(l.theta), degrees(l.phi), degrees(v.theta), degrees(v.phi));
}

}  // namespace vamp
