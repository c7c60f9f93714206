#pragma once
// The scenes that benchmarks run on.
#include <string>

#include "engine/core/error.h"
#include "engine/project/project.h"

namespace vamp {

// A model or project, or the shipped shoe in its leather and cloth where `file` is empty; if `without` is not empty,
// its part of that name is left out, such as a backdrop that stretches the tree's grid.
Result<Project> bench_project(const std::string& file, const std::string& without = {});

// "the shipped shoe, 242,676 triangles".
std::string scene_words(const std::string& file, const Project& project);

}  // namespace vamp
