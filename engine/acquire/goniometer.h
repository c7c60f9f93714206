#pragma once
// Light paths through a mesostructure, seen along one direction and lit from all directions at once.
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/acquire/facet_grid.h"
#include "engine/acquire/random.h"

namespace vamp {
class Progress;
}

namespace vamp::acquire {

enum class Shadows {
  tabulated,  // one table for all: whether each light reaches one point of each facet
  traced,     // a ray for each vertex and light: the reference that the table is measured against
};

class Goniometer {
 public:
  static constexpr size_t kMaxLights = 192;

  // Directions towards the lights are unit vectors above the plane. `threads` (0: one per core) work on the table; when
  // `progress` is cancelled meanwhile, it stays unfinished and the goniometer is of no use.
  Goniometer(Mesostructure structure, std::vector<vec3> lights, Shadows shadows, int threads,
             const Progress* progress = nullptr);

  size_t light_count() const { return lights_.size(); }
  // Height of the plane that texels lie on, in periods: the mean of what is seen from above.
  float reference_height() const { return reference_height_; }
  const FacetGrid& grid() const { return grid_; }

  // Adds one path's estimate of the radiance that leaves the layer towards `view`, through the point `place` of the
  // reference plane, for each light: parallel, white, irradiance 1 on a plane that faces it. That is ReflectedCos.
  // radiance[3 * light + channel]. Paths end by Russian roulette alone, so nothing is cut off.
  void trace(vec2 place, vec3 view, Random& random, std::span<float> radiance) const;

  // The same for a sky of radiance 1 all around: what the path has left when it leaves the layer. A path of white
  // Lambert facets has everything left.
  vec3 trace_sky(vec2 place, vec3 view, Random& random) const;

 private:
  using LightBits = std::array<uint64_t, kMaxLights / 64>;
  struct Vertex;
  template <class Gather>
  vec3 follow(vec2 place, vec3 view, Random& random, Gather gather) const;
  void gather_lights(const Vertex& vertex, vec3 throughput, std::span<float> radiance) const;
  bool scatter(const Vertex& vertex, Random& random, vec3& throughput, vec3& direction) const;
  bool is_lit(const Vertex& vertex, size_t light) const;
  void tabulate_shadows(int threads, const Progress* progress);
  void tabulate_facet(uint32_t index);
  void find_reference_height();

  FacetGrid grid_;
  std::vector<Matter> matters_;
  std::vector<float> coat_albedo_;  // of each matter, at 45 degrees
  std::vector<vec3> lights_;
  std::vector<LightBits> lit_;  // of each facet; empty where shadows are traced
  float reference_height_ = 0;
};

}  // namespace vamp::acquire
