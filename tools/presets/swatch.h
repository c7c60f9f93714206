#pragma once
// Pictures of a material by its oracle: a lit ball for the preset's thumbnail, a flat patch to judge it by.
#include "engine/image/image.h"
#include "engine/material/tables.h"

namespace vamp::presets {

class Swatch {
 public:
  explicit Swatch(const Spmm& spmm, const EditLayer& edits = {});

  // A ball of `ball_mm` on a neutral grey ground, seen orthographically; key light upper left, soft fill, rim behind.
  // Linear Rec.709, display-ready exposure.
  Image ball(int side, double ball_mm) const;

  // A flat patch of `mm` seen at `view` degrees from its normal, lit by one lamp at `light` degrees from the other
  // side.
  Image patch(int side, double mm, double view_degrees, double light_degrees, double light_azimuth) const;

  // ReflectedCos at a place in mm.
  dvec3 value(double x_mm, double y_mm, dvec3 wi, dvec3 wo) const;

 private:
  const Spmm& spmm_;
  EditedTables edited_;
  int terms_;
  DirectionTables directions_;
};

}  // namespace vamp::presets
