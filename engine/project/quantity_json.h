#pragma once
// Numbers with units between a file (mm, degrees) and a project (scene units, radians). Each reads back as the very
// float it was written from: the digits of a double are used where a float's do not do.
#include <string_view>

#include "engine/core/json.h"
#include "engine/core/vec.h"

namespace vamp {

// value * factor, in the fewest digits from which quantity_from gives `value` again. factor > 0.
Json json_quantity(float value, double factor);
// The number in the file divided by `factor`; `low` and `high` are in the project's unit.
float quantity_from(const JsonReader& reader, double factor, float low, float high);

inline constexpr double kDegreesPerRadian = 57.295779513082320877;

Json json_vector(const vec2& v, double factor = 1);
Json json_vector(const vec3& v, double factor = 1);
vec2 vec2_from(const JsonReader& reader, double factor, float low, float high);
vec3 vec3_from(const JsonReader& reader, double factor, float low, float high);

// One of a list of names; refuses others with the list.
size_t choice_from(const JsonReader& reader, std::initializer_list<std::string_view> names);

}  // namespace vamp
