#include "app/commands/colour_option.h"

#include "engine/project/job_options.h"

namespace vamp {

Result<vec3> colour_option(std::string_view text, std::string_view option) {
  if (text == "white") return vec3(1);
  if (text == "black") return vec3(0);
  Result<vec3> colour = parse_color(text, option);
  if (!colour) colour.error().expected += ", white or black";
  return colour;
}

}  // namespace vamp
