#pragma once
// Woven cloth: two families of elliptical yarns that pass over and under each other.
#include "engine/acquire/structure.h"

namespace vamp::acquire {

struct Weave : Structure {
  std::string name = "weave";
  float mm = 12;
  float ends = 20, picks = 20;  // warp and weft yarns across the period; rounded to whole repeats
  float over = 1, under = 1;    // weft yarns that a warp yarn passes over, then under
  float step = 1;               // how far the next warp yarn is shifted
  float relief = 1;             // factor of all heights
  float cover = 0.98f;          // width of the yarns, share of their distance
  float thickness = 0.75f;      // of the yarns, share of their width
  float crimp = 0.5f;           // share of the bending that the warp takes
  float slub = 0.06f;           // how uneven the yarns are
  vec3 warp{0.5f}, weft{0.5f};
  vec3 second{0.5f};  // mixed into both, fibre by fibre
  float blend = 0;
  float turns = 1;                      // of the fibres, per mm
  float ply_depth = 0.16f;              // grooves between two plies
  float coat = 0.06f;                   // strength of the highlight along the fibres
  float along = 0.18f, across = 0.45f;  // its widths
  float hairs = 0;                      // stray fibres per square mm
  vec3 backing{0.03f};                  // seen between the yarns

  std::vector<Setting> settings() override;
  Mesostructure build(int cells) const override;
};

}  // namespace vamp::acquire
