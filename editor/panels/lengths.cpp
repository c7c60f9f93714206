#include "editor/panels/lengths.h"

#include <algorithm>
#include <cmath>

#include "editor/panels/subject.h"
#include "engine/project/limits.h"

namespace vamp::ui {

namespace {

float middle_to(float value, float low, float high) {
  const float t = (value - low) / (high - low) * 2 - 1;
  return 0.5f + 0.5f * std::copysign(std::sqrt(std::abs(t)), t);
}
float middle_from(float t, float low, float high) {
  if (t <= 0) return low;
  if (t >= 1) return high;
  const float s = t * 2 - 1;
  return low + (high - low) * (0.5f + 0.5f * s * std::abs(s));
}
float log1_to(float value, float low, float high) {
  return std::log((1 + value) / (1 + low)) / std::log((1 + high) / (1 + low));
}
float log1_from(float t, float low, float high) {
  if (t <= 0) return low;
  return t >= 1 ? high : (1 + low) * std::pow((1 + high) / (1 + low), t) - 1;
}

// A number that is easy to read and at least `value`: 1, 2 or 5 times a power of ten.
float round_up(float value) {
  const float power = std::pow(10.0f, std::floor(std::log10(value)));
  for (const float step : {1.0f, 2.0f, 5.0f}) {
    if (step * power >= value) return step * power;
  }
  return 10 * power;
}

}  // namespace

const Mapping kFromMiddle{middle_to, middle_from};
const Mapping kLogFromZero{log1_to, log1_from};

float model_radius_mm(const Project& project) {
  const float radius = subject_bounds(project).radius() * project.mm_per_unit;
  return std::isfinite(radius) ? std::max(radius, 1.0f) : 1.0f;
}

Parameter coordinate_row(const Project& project, const char* label, const char* description, float value_mm,
                         float initial_mm) {
  const float reach = round_up(std::max({10 * model_radius_mm(project), std::abs(value_mm), std::abs(initial_mm)}));
  Parameter row{label, -reach, reach, initial_mm, "%.1f mm", description, "mm", &kFromMiddle};
  return row;
}

Parameter shift_row(const Project& project, const char* label, const char* description, float value_mm) {
  const float reach = round_up(std::max(2 * model_radius_mm(project), std::abs(value_mm)));
  Parameter row{label, -reach, reach, 0, "%.1f mm", description, "mm", &kFromMiddle};
  return row;
}

Parameter length_row(const Project& project, const char* label, const char* description, float value_mm,
                     float initial_mm) {
  const float high = round_up(std::max({10 * model_radius_mm(project), value_mm, initial_mm}));
  const float low = std::max(kMinLength * project.mm_per_unit, std::min({high * 1e-4f, value_mm, initial_mm}));
  Parameter row{label, low, high, initial_mm, "%.1f mm", description, "mm", &kLog};
  return row;
}

Parameter angle_row(const char* label, const char* description, float low, float high, float initial) {
  Parameter row{label, low, high, initial, "%.1f°", description, "degrees"};
  return row;
}

}  // namespace vamp::ui
