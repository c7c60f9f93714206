#include "engine/project/quantity_json.h"

#include <fmt/format.h>

#include <cmath>

namespace vamp {
namespace {

// Scale by one double division both when the shortest text is sought and when it is read: the same arithmetic.
float in_project(double number, double factor) { return static_cast<float>(number / factor); }

template <class Vector>
Json vector_to_json(const Vector& v, double factor) {
  Json json = Json::array();
  for (int i = 0; i < Vector::length(); ++i) json.push_back(json_quantity(v[i], factor));
  return json;
}

template <class Vector>
Vector vector_from(const JsonReader& reader, double factor, float low, float high) {
  Vector v(0);
  constexpr auto count = static_cast<size_t>(Vector::length());
  if (const size_t size = reader.size(count); size != count) {
    reader.refuse(fmt::format("{} numbers", count), std::to_string(size));
    return v;
  }
  for (size_t i = 0; i < count; ++i) v[static_cast<int>(i)] = quantity_from(reader.element(i), factor, low, high);
  return v;
}

}  // namespace

Json json_quantity(float value, double factor) {
  const double scaled = static_cast<double>(value) * factor;
  const auto rounded = static_cast<float>(scaled);
  const Json brief = json_number(rounded);
  if (in_project(brief.get<double>(), factor) == value) return brief;
  return scaled;
}

float quantity_from(const JsonReader& reader, double factor, float low, float high) {
  // The bounds may round to just inside of what was written: they are widened by a double's rounding.
  const auto bound = [factor](float edge, double outwards) {
    const double scaled = static_cast<double>(edge) * factor;
    return scaled + outwards * std::abs(scaled) * 1e-12;
  };
  const float value = in_project(reader.real(bound(low, -1), bound(high, 1)), factor);
  return value < low ? low : value > high ? high : value;
}

Json json_vector(const vec2& v, double factor) { return vector_to_json(v, factor); }
Json json_vector(const vec3& v, double factor) { return vector_to_json(v, factor); }
vec2 vec2_from(const JsonReader& reader, double factor, float low, float high) {
  return vector_from<vec2>(reader, factor, low, high);
}
vec3 vec3_from(const JsonReader& reader, double factor, float low, float high) {
  return vector_from<vec3>(reader, factor, low, high);
}

size_t choice_from(const JsonReader& reader, std::initializer_list<std::string_view> names) {
  const std::string name = reader.text(64);
  size_t index = 0;
  for (const std::string_view candidate : names) {
    if (candidate == name) return index;
    ++index;
  }
  reader.refuse(fmt::format("one of {}", fmt::join(names.begin(), names.end(), ", ")), "\"" + name + "\"");
  return 0;
}

}  // namespace vamp
