#pragma once
// Suede and nubuck: a nap of short fibres, brushed one way and ruffled here and there.
#include "engine/acquire/structure.h"

namespace vamp::acquire {

struct Suede : Structure {
  std::string name = "suede";
  float mm = 10;
  float relief = 0.8f;   // factor of all heights
  float density = 260;   // fibres per square mm
  float length = 0.3f;   // mm, of a fibre
  float radius = 0.02f;  // mm
  float lean = 0.86f;    // 0: upright, 1: lying
  float ruffle = 1;      // how far tufts turn away from the brush
  float ground = 0.05f;  // mm, height of the skin's own unevenness
  vec3 colour{0.37f, 0.23f, 0.125f};
  vec3 root_colour{0.3f, 0.18f, 0.095f};
  float mottling = 0.3f;  // relative
  float coat = 0.03f;     // strength of the fibres' highlight
  float roughness = 0.45f;

  std::vector<Setting> settings() override;
  Mesostructure build(int cells) const override;
};

}  // namespace vamp::acquire
