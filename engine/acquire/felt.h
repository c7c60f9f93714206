#pragma once
// Felt: fibres in every direction, pressed together, with some that stand out.
#include "engine/acquire/structure.h"

namespace vamp::acquire {

struct Felt : Structure {
  std::string name = "felt";
  float mm = 10;
  float density = 30;     // fibres per square mm
  float length = 3.5f;    // mm
  float radius = 0.028f;  // mm
  float relief = 1;       // factor of all heights
  float loft = 0.35f;     // mm, of the layer that is seen
  float stray = 0.12f;    // share of the fibres that stand out
  vec3 colour{0.30f, 0.31f, 0.33f};
  vec3 second{0.12f, 0.12f, 0.13f};  // of some of the fibres
  float blend = 0.3f;                // share of those
  float coat = 0.04f;                // strength of the highlight along the fibres
  float along = 0.25f, across = 0.6f;

  std::vector<Setting> settings() override;
  Mesostructure build(int cells) const override;
};

}  // namespace vamp::acquire
