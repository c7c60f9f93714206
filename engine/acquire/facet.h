#pragma once
// What the virtual goniometer looks at: a layer of small triangles that repeats in x and y. Everything that has a shape
// (yarns, grain, holes) is made of them, so that one tracer and one estimator serve all mesostructures.
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "engine/brdf/lobe.h"
#include "engine/core/vec.h"

namespace vamp::acquire {

// How a facet reflects: a body in the facet's colour under a coat in a colour of its own, added. The coat's x axis runs
// along the facet's fibre.
struct Matter {
  Lobe body{Model::lambert, 0, {1}};
  Lobe coat{Model::cook_torrance, 0, {1, 0.3f, 0.04f}};
  vec3 coat_colour{0};  // black: no coat
};

// Lengths in periods: the layer is the unit square repeated, x to the right, y up, z towards the viewer.
struct Facet {
  std::array<vec3, 3> corner;  // counter-clockwise seen from outside; any place, the layer wraps it
  vec3 colour{0.5f};           // of the body, linear Rec.709, 0 to 1
  vec3 fibre{1, 0, 0};         // need not lie in the facet; a facet normal to it takes any direction
  uint8_t matter = 0;
};

struct Mesostructure {
  std::string name;
  double mm = 16;  // one period
  std::vector<Facet> facets;
  std::vector<Matter> matters;
};

}  // namespace vamp::acquire
