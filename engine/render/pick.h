#pragma once
// What lies under a pixel of a picture.
#include "engine/core/vec.h"

namespace vamp {

struct Pick {
  int part = -1;  // -1: background
  int material = -1;
  int cluster = -1;
  vec2 uv{0, 0};
  vec3 position{0, 0, 0};
  float distance = 0;
};

struct Drawn;  // what a picture is of (shown_picture.h)

// By a CPU ray through (x, y), in pixels from the top left corner, against the hierarchy that the kernels walk.
Pick pick_in(const Drawn& drawn, float x, float y);

}  // namespace vamp
