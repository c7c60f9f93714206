#pragma once
// Grained leather: plates between creases, finer wrinkles on them, pores, and a finish over it.
#include "engine/acquire/height_field.h"
#include "engine/acquire/structure.h"

namespace vamp::acquire {

struct Leather : Structure {
  std::string name = "leather";
  float mm = 12;
  float plates = 15;           // across the period
  float relief = 1;            // factor of all heights
  float plate_height = 0.11f;  // mm
  float crease_width = 0.13f;  // of a plate
  float wrinkles = 0.03f;      // mm
  float pores = 0.35f;         // share of the places where one could be
  float pore_depth = 0.07f;    // mm
  float mottling = 0.12f;      // relative
  vec3 colour{0.33f, 0.128f, 0.044f};
  vec3 crease_colour{0.115f, 0.036f, 0.012f};
  float coat = 1;          // factor of the finish
  float roughness = 0.3f;  // of the finish: Cook-Torrance's m
  float f0 = 0.05f;
  float fuzz = 0;  // Oren-Nayar's sigma of the body, radians

  std::vector<Setting> settings() override;
  Mesostructure build(int cells) const override;

 protected:
  Skin skin(double u, double v) const;
  // 0: as finished; 1: where the finish does not reach.
  std::vector<Matter> matters() const;
};

}  // namespace vamp::acquire
