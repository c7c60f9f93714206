#pragma once
// Leather with a pattern pressed into it: the scales of a crocodile, glazed.
#include "engine/acquire/structure.h"

namespace vamp::acquire {

struct Emboss : Structure {
  std::string name = "emboss";
  float mm = 32;
  float columns = 5, rows = 7;  // scales across the period; rows rounded to an even number
  float relief = 1;             // factor of all heights
  float depth = 1.1f;           // mm, of the grooves
  float groove = 0.1f;          // width, share of a scale
  float irregular = 0.32f;      // 0: bricks
  float wrinkles = 0.05f;       // mm
  vec3 colour{0.105f, 0.032f, 0.012f};
  vec3 groove_colour{0.018f, 0.006f, 0.003f};
  float coat = 1;  // factor of the glaze
  float roughness = 0.13f;
  float f0 = 0.05f;

  std::vector<Setting> settings() override;
  Mesostructure build(int cells) const override;
};

}  // namespace vamp::acquire
