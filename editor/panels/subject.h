#pragma once
// How large the thing is that the picture is about.
#include "engine/project/project.h"

namespace vamp::ui {

// The bounds of the visible parts, without floors and backdrops: flat parts more than three times as large as all that
// are not flat together. Of everything where nothing is visible.
Bounds subject_bounds(const Project& project);

}  // namespace vamp::ui
