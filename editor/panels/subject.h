#pragma once
// How large the thing is that the picture is about.
#include "engine/project/project.h"

namespace vamp::ui {

// The bounds of the visible parts, without floors and backdrops: parts that are flat, or
// the largest of several, and more than three times as large as all others together. Of everything where nothing is
// visible.
Bounds subject_bounds(const Project& project);

}  // namespace vamp::ui
