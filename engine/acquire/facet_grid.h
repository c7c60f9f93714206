#pragma once
// Rays through a periodic layer of facets: a grid over one period, walked in two levels, wrapping at its sides.
#include <cstdint>
#include <vector>

#include "engine/acquire/facet.h"

namespace vamp::acquire {

class FacetGrid {
 public:
  // At least one facet with an area; corners finite. Facets that reach over a side of the unit square are copied to the
  // other one.
  explicit FacetGrid(std::vector<Facet> facets);

  static constexpr uint32_t kNone = ~0u;
  struct Hit {
    uint32_t facet = kNone;
    vec3 point{0};  // x and y in [0, 1) up to rounding
  };

  // The first facet whose front the ray meets, or kNone. `direction` need not be a unit vector; `ignored` is not hit. A
  // ray that starts above the layer is taken from where it enters it.
  Hit first_hit(vec3 origin, vec3 direction, uint32_t ignored = kNone) const;
  // Whether it meets any.
  bool is_blocked(vec3 origin, vec3 direction, uint32_t ignored = kNone) const;

  const std::vector<Facet>& facets() const { return facets_; }
  // Of unit length, towards the outside.
  vec3 normal(uint32_t facet) const;
  float top() const { return top_; }
  float bottom() const { return bottom_; }

 private:
  struct Range {
    float low, high;  // of facets in z
  };
  struct Search;
  template <bool kAny>
  Hit walk(vec3 origin, vec3 direction, uint32_t ignored) const;
  template <bool kAny>
  bool walk_block(int block_x, int block_y, float enter, float leave, Search& search) const;
  void wrap_facets();
  void fill_cells();

  std::vector<Facet> facets_;
  int side_ = 8;  // cells, in blocks of 8 x 8 that a ray passes at once where it is above or below all of them
  std::vector<Range> blocks_, ranges_;
  std::vector<uint32_t> first_;  // of each cell in references_, and the end
  std::vector<uint32_t> references_;
  float top_ = 0, bottom_ = 0;
};

}  // namespace vamp::acquire
