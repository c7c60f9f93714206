#pragma once
// Corduroy: ribs of upright pile on a woven ground.
#include "engine/acquire/structure.h"

namespace vamp::acquire {

struct Corduroy : Structure {
  std::string name = "corduroy";
  float mm = 12;
  float ribs = 6;           // across the period
  float relief = 1;         // factor of all heights
  float pile = 0.85f;       // mm, height of a rib
  float tufts = 34;         // along the period
  float roughness = 0.09f;  // mm, unevenness of the pile's ends
  vec3 colour{0.30f, 0.14f, 0.045f};
  vec3 ground_colour{0.10f, 0.045f, 0.015f};
  float coat = 0.035f;  // strength of the sheen

  std::vector<Setting> settings() override;
  Mesostructure build(int cells) const override;
};

}  // namespace vamp::acquire
