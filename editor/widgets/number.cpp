#include "editor/widgets/number.h"

#include <algorithm>
#include <charconv>
#include <cmath>

namespace vamp::ui {

namespace {

float linear_to(float value, float low, float high) { return high > low ? (value - low) / (high - low) : 0; }
float linear_from(float t, float low, float high) { return t >= 1 ? high : low + t * (high - low); }
float square_to(float value, float low, float high) { return std::sqrt(std::max(0.0f, linear_to(value, low, high))); }
float square_from(float t, float low, float high) { return linear_from(t * t, low, high); }
float log_to(float value, float low, float high) { return std::log(value / low) / std::log(high / low); }
float log_from(float t, float low, float high) {
  if (t <= 0) return low;
  return t >= 1 ? high : low * std::pow(high / low, t);
}

}  // namespace

const Mapping kLinear{linear_to, linear_from};
const Mapping kSquare{square_to, square_from};
const Mapping kLog{log_to, log_from};

float admit(const Parameter& parameter, float value) {
  if (!std::isfinite(value)) return parameter.initial;
  const float width = parameter.high - parameter.low;
  if (parameter.wraps && width > 0 && (value < parameter.low || value > parameter.high)) {
    value -= width * std::floor((value - parameter.low) / width);
  }
  if (parameter.whole) value = std::round(value);
  return std::clamp(value, parameter.low, parameter.high);
}

std::optional<float> parse_number(std::string_view text) {
  const size_t start = text.find_first_not_of(" \t+");
  if (start == std::string_view::npos) return std::nullopt;
  std::string number(text.substr(start));
  std::replace(number.begin(), number.end(), ',', '.');
  float value = 0;
  const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), value);
  if (error != std::errc() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::string print_number(float value) {
  char text[32];
  const auto [end, error] = std::to_chars(text, text + sizeof text, value);
  return error == std::errc() ? std::string(text, end) : std::string();
}

}  // namespace vamp::ui
