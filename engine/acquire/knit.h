#pragma once
// Knitted cloth: plain jersey, rows of loops drawn through those of the row below.
#include "engine/acquire/structure.h"

namespace vamp::acquire {

struct Knit : Structure {
  std::string name = "knit";
  float mm = 14;
  float wales = 10;     // loops across the period
  float courses = 14;   // rows of them
  float relief = 1;     // factor of all heights
  float width = 0.46f;  // of the yarn, share of a wale
  float bulge = 0.3f;   // of the loops, share of a wale
  float turns = 1.1f;   // of the fibres, per mm
  float ply_depth = 0.22f;
  float unevenness = 0.08f;
  vec3 colour{0.36f, 0.045f, 0.04f};
  vec3 second{0.5f, 0.12f, 0.1f};  // mixed in, fibre by fibre
  float blend = 0.3f;
  float coat = 0.05f;  // strength of the highlight along the fibres
  float along = 0.2f, across = 0.5f;
  float hairs = 3;  // stray fibres per square mm
  vec3 backing{0.02f};

  std::vector<Setting> settings() override;
  Mesostructure build(int cells) const override;
};

}  // namespace vamp::acquire
