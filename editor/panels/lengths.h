#pragma once
// Rows for places and lengths: millimetres and degrees on the screen, whatever the project's unit is.
#include "editor/widgets/number.h"
#include "engine/project/project.h"

namespace vamp::ui {

// Finer near the middle of the range, for coordinates.
extern const Mapping kFromMiddle;
// Equal ratios of 1 + value, for ranges that begin at 0 (the registry's logarithmic rows).
extern const Mapping kLogFromZero;

// A coordinate in mm within ten times the model's size of the origin, or as far as `value` and `initial` reach.
Parameter coordinate_row(const Project& project, const char* label, const char* description, float value_mm,
                         float initial_mm);

// How far something is moved to either side, in mm: up to about twice the model's size, or as far as `value`.
Parameter shift_row(const Project& project, const char* label, const char* description, float value_mm);

// A length above 0 in mm.
Parameter length_row(const Project& project, const char* label, const char* description, float value_mm,
                     float initial_mm);

// Degrees from `low` to `high`.
Parameter angle_row(const char* label, const char* description, float low, float high, float initial);

// The radius of the model in mm, at least 1.
float model_radius_mm(const Project& project);

}  // namespace vamp::ui
