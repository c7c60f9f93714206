#pragma once
// A colour of an option.
#include <string_view>

#include "engine/core/error.h"
#include "engine/core/vec.h"

namespace vamp {

// r,g,b (linear), #rrggbb (sRGB), white or black.
Result<vec3> colour_option(std::string_view text, std::string_view option);

}  // namespace vamp
