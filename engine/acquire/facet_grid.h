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

  // The first facet whose front the ray meets, or kNone. Backs are passed: what is seen from outside is closed, and a
  // path that starts a rounding error below its neighbour in a crease comes out. `direction` need not be a unit vector;
  // `ignored` is not hit. A ray that starts above the layer is taken from where it enters it.
  Hit first_hit(vec3 origin, vec3 direction, uint32_t ignored = kNone) const;
  // Whether it meets any, from either side: where one yarn lies inside another, no light comes out of it.
  bool is_blocked(vec3 origin, vec3 direction, uint32_t ignored = kNone) const;

  // Whether a point lies in a yarn: straight above it the first facet shows its back.
  bool is_inside(vec3 point) const;

  const std::vector<Facet>& facets() const { return facets_; }
  // Of unit length, towards the outside.
  vec3 normal(uint32_t facet) const;
  float top() const { return top_; }
  float bottom() const { return bottom_; }

 private:
  struct Search;
  enum class Sought { first_front, first, any };
  template <Sought kSought>
  Hit walk(vec3 origin, vec3 direction, uint32_t ignored) const;
  template <Sought kSought>
  bool walk_block(glm::ivec3 block, float enter, float leave, Search& search) const;
  void wrap_facets();
  void choose_cells();
  void fill_cells();
  template <class Visit>
  void visit_cells(const Facet& facet, Visit visit) const;
  size_t block_start(glm::ivec3 block) const;
  size_t index(glm::ivec3 cell) const;

  std::vector<Facet> facets_;
  float top_ = 0, bottom_ = 0;
  glm::ivec3 cells_{8};          // along x, y and z; whole blocks of 8 x 8 x 8
  vec3 scale_{8};                // cells to a period
  std::vector<uint32_t> first_;  // of each cell in references_, and the end; cells of a block lie together
  std::vector<uint32_t> references_;
};

}  // namespace vamp::acquire
