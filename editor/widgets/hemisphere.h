#pragma once
// A direction on the hemisphere about the surface normal, such as the frame normal of a basis.
#include "editor/widgets/row.h"
#include "engine/core/vec.h"

namespace vamp::ui {

// tilt from the surface normal and azimuth, both in degrees.
struct Tilt {
  float tilt = 0;
  float azimuth = 0;  // 0 .. 360, counter-clockwise from the tangent direction
};

// A disk that shows the hemisphere from above, with a handle to drag, beside a caption and rows for tilt
// (0 .. `max_tilt`) and azimuth. Shift drags at a tenth of the speed; reset goes to `initial`.
EditOf<Tilt> direction_row(const char* label, Tilt& direction, const Tilt& initial, float max_tilt,
                           const char* description, const RowState& state = {});

// Unit vectors of the local frame (z the normal) and back.
vec3 direction_from_tilt(const Tilt& tilt);
Tilt tilt_from_direction(const vec3& direction);

}  // namespace vamp::ui
