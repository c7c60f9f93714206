#pragma once
// Three scenes, each from one camera, under one rectangle and one sphere light, all parts white and Lambertian.
#include <string>

#include "engine/project/project.h"

namespace vamp {

inline constexpr int kViewCount = 3;

struct View {
  std::string name;
  Project project;
};

// 0: the derby of scenes/; 1: bumps, boxes and blades; 2: the shoe of the test data where VAMP_TEST_DATA names its
// folder, else shelves. Errors: a file that cannot be read.
Result<View> make_view(int number);

}  // namespace vamp
