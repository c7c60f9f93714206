#pragma once
// How large the thing is that the picture is about.
#include <vector>

#include "engine/project/project.h"

namespace vamp::ui {

// The bounds of the visible parts where they stand, without floors and backdrops: parts that are flat, or
// the largest of several, and more than three times as large as all others together. Of everything where nothing is
// visible.
Bounds subject_bounds(const Project& project);

// The corners of its triangles, and of one part's; a corner that triangles share may be there more than once.
std::vector<vec3> subject_points(const Project& project);
std::vector<vec3> part_points(const Project& project, int part);

}  // namespace vamp::ui
