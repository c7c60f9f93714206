#pragma once
// Air mesh: a knitted face with holes over a closed back, apart from each other.
#include "engine/acquire/structure.h"

namespace vamp::acquire {

struct AirMesh : Structure {
  std::string name = "air-mesh";
  float mm = 12;
  float holes = 4;      // across the period
  float hole_rows = 6;  // rounded to an even number
  float open = 0.56f;   // size of the holes, share of their distance
  float relief = 1;     // factor of all heights
  float gap = 1.6f;     // mm, from face to back
  float stitches = 3;   // of the face between two holes
  vec3 colour{0.10f, 0.32f, 0.42f};
  vec3 back{0.025f, 0.03f, 0.035f};
  float coat = 0.07f;  // strength of the filaments' highlight
  float along = 0.16f, across = 0.4f;

  std::vector<Setting> settings() override;
  Mesostructure build(int cells) const override;
};

}  // namespace vamp::acquire
