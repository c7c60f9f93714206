#pragma once
// The scenes that benchmarks run on.
#include <string>

#include "engine/core/error.h"
#include "engine/project/project.h"

namespace vamp {

// A model or project; the shipped shoe in its leather and cloth where `file` is empty; "shapes" or "shapes:TRIANGLES",
// 250,000 unless said, for shapes_project(). If `without` is not empty, the part of that name is left out, such as a
// backdrop that stretches the tree's grid. The errors of files; of a number or a part that is none, usage.
Result<Project> bench_project(const std::string& file, const std::string& without = {});

// Keeps the first light, and gives ambient light and a radius for it where there is none: one primary, one shadow and
// one ambient ray a sample. Errors: no light.
Status keep_one_light(Project& project);

// "the shipped shoe, 242,676 triangles".
std::string scene_words(const std::string& file, const Project& project);

}  // namespace vamp
