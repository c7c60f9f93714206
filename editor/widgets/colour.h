#pragma once
// Colours: linear Rec.709 in the values, sRGB on the screen, in hex and in the picker.
#include <optional>
#include <string>

#include "editor/widgets/row.h"
#include "engine/core/vec.h"

namespace vamp::ui {

// The sRGB transfer function (IEC 61966-2-1), for 0 .. 1; outside it is clamped.
float srgb_from_linear(float linear);
float linear_from_srgb(float encoded);
std::string hex_from_linear(const vec3& linear);             // "#A8623A"
std::optional<vec3> linear_from_hex(std::string_view text);  // with or without #, 3 or 6 digits
ImU32 screen_colour(const vec3& linear);

// label | swatch, a click opens the picker | hex entry | reset. Values 0 .. 1.
EditOf<vec3> colour_row(const char* label, vec3& linear, const vec3& initial, const char* description,
                        const RowState& state = {});

// A weight with its colour: label | slider of the largest component | swatch of the colour relative to it | number |
// reset. `high` is the largest gain of the slider; the default is 1, 1, 1.
EditOf<vec3> gain_row(const char* label, vec3& gain, float high, const char* description, const RowState& state = {});

// Only a swatch with a picker, for table cells.
EditOf<vec3> colour_swatch(const char* id, vec3& linear, ImVec2 size);

}  // namespace vamp::ui
