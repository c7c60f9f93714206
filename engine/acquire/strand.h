#pragma once
// Yarns and fibres: elliptical tubes along curves, with a twist that the fibres on their surface follow.
#include <cstdint>
#include <functional>
#include <glm/vec3.hpp>
#include <vector>

#include "engine/acquire/facet.h"

namespace vamp::acquire {

struct Strand {
  std::vector<glm::dvec3> centre;  // mm, at least 2 points
  double half_width = 0.2;         // mm, in the plane
  double half_thickness = 0.2;     // mm, across it
  int sides = 6;
  // A strand that goes on for ever: its end is its beginning, moved by this many mm. Others taper off at both ends.
  bool endless = false;
  glm::dvec3 period{0};
  double turns = 0;       // of the fibres, along the whole strand
  int plies = 0;          // yarns twisted together, 0 for one
  double ply_depth = 0;   // of the grooves between them, share of the radius
  double unevenness = 0;  // of the bundle of fibres, share of the radius
  int fibre_cells = 0;    // lengthwise cells of that unevenness
  vec3 colour{0.5f};
  vec3 second_colour{0.5f};
  float blend = 0;  // how much of the second colour is mixed in, fibre by fibre
  uint8_t matter = 0;
  uint32_t seed = 0;
};

// Appends the strand's facets, scaled to periods of `mm`.
void add_strand(std::vector<Facet>& facets, double mm, const Strand& strand);

// Appends a plane of cells^2 squares at a height in mm: what is seen between yarns.
void add_ground(std::vector<Facet>& facets, double mm, int cells, double height, vec3 colour, uint8_t matter);

// A stray fibre of `length` mm that wanders from `start` (mm) in direction `angle`, its height following `rise` from 0
// to 1 along the way.
struct Wander {
  glm::dvec3 start{0};
  double angle = 0, length = 1, curl = 1;
  int points = 12;
  uint32_t seed = 0;
};
std::vector<glm::dvec3> wander(const Wander& how, const std::function<double(double)>& rise);

}  // namespace vamp::acquire
