#pragma once
// Numbers on sliders and in text fields.
#include <optional>
#include <string>
#include <string_view>

namespace vamp::ui {

// Where a value stands on its slider (0 .. 1) and back. Both ends must map exactly.
struct Mapping {
  float (*to_slider)(float value, float low, float high);
  float (*from_slider)(float t, float low, float high);
};
extern const Mapping kLinear;
extern const Mapping kSquare;  // finer near the low end
extern const Mapping kLog;     // equal ratios; the low end must be above 0

struct Parameter {
  const char* label = "";
  float low = 0;
  float high = 1;
  float initial = 0;            // the default: tick and reset
  const char* format = "%.2f";  // with the unit, such as "%.1f°" or "%.0f of 4"
  const char* description = "";
  const char* unit = "";  // for the tooltip, such as "mm"
  const Mapping* mapping = &kLinear;
  bool whole = false;  // integers only
  bool wraps = false;  // an angle: past the end it begins again
};

// Into the range (wrapped for angles), rounded where whole; a value that is not finite becomes the default.
float admit(const Parameter& parameter, float value);

// The number at the start of the text, a decimal comma allowed, anything after it (a unit) ignored; nothing when there
// is none or it is not finite.
std::optional<float> parse_number(std::string_view text);

// The shortest text that reads back as the same float.
std::string print_number(float value);

}  // namespace vamp::ui
