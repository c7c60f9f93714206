#pragma once
// Values of plain options, read strictly: the whole text, no octal, no "nan". What is wrong is ErrorKind::usage.
#include <cstdint>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/core/error.h"
#include "engine/core/vec.h"

namespace vamp {

Result<float> number_option(std::string_view text, std::string_view option, float low, float high);
Result<uint32_t> count_option(std::string_view text, std::string_view option, uint32_t low, uint32_t high);

// "x,y,z", each in the range.
Result<vec3> vector_option(std::string_view text, std::string_view option, float low, float high);

// "a,b,c" into its pieces; empty text gives none.
std::vector<std::string_view> list_option(std::string_view text);

// "PART=VALUE", cut at the first "="; neither side may be empty.
Result<std::pair<std::string_view, std::string_view>> pair_option(std::string_view text, std::string_view option);

}  // namespace vamp
