#include "engine/acquire/facet_grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "engine/acquire/random.h"
#include "tests/acquire/shapes.h"

namespace vamp::acquire {
namespace {

vec3 anywhere(Random& random) { return {random.next(), random.next(), random.next()}; }

// Facets of all sizes, some across the sides of the period.
std::vector<Facet> soup(int count, float size, uint64_t seed) {
  Random random(seed);
  std::vector<Facet> facets(static_cast<size_t>(count));
  for (Facet& facet : facets) {
    const vec3 middle = anywhere(random) * vec3(3, 3, 0.3f) - vec3(1, 1, 0);
    for (vec3& corner : facet.corner) corner = middle + (anywhere(random) - 0.5f) * size * (0.2f + random.next());
  }
  return facets;
}

// In double precision, over all copies of all facets that could matter.
double nearest(const std::vector<Facet>& facets, vec3 origin, vec3 direction, bool backs) {
  double best = std::numeric_limits<double>::infinity();
  for (const Facet& facet : facets)
    for (int y = -6; y <= 6; ++y)
      for (int x = -6; x <= 6; ++x) {
        const dvec3 by(x, y, 0), d(direction);
        const dvec3 a = dvec3(facet.corner[0]) + by, e1 = dvec3(facet.corner[1]) + by - a,
                    e2 = dvec3(facet.corner[2]) + by - a;
        const dvec3 n = glm::cross(e1, e2), s = dvec3(origin) - a;
        const double facing = -glm::dot(d, n);
        if (backs ? facing == 0 : facing <= 0) continue;
        const double t = glm::dot(s, n) / facing;
        const dvec3 m = glm::cross(s, d);
        const double u = glm::dot(e2, m) / facing, v = -glm::dot(e1, m) / facing;
        if (t > 0 && u >= 0 && v >= 0 && u + v <= 1) best = std::min(best, t);
      }
  return best;
}

TEST(FacetGrid, FindsWhatTestingEveryCopyOfEveryFacetFinds) {
  int hits = 0;
  for (const int count : {1, 7, 60, 400}) {
    const std::vector<Facet> facets = soup(count, count > 100 ? 0.1f : 0.6f, static_cast<uint64_t>(count));
    const FacetGrid grid(facets);
    Random random(99);
    for (int i = 0; i < 300; ++i) {
      const vec3 origin = anywhere(random) * vec3(1, 1, 0.5f);
      vec3 direction = anywhere(random) - 0.5f;
      direction.z += direction.z < 0 ? -0.15f : 0.15f;
      direction = glm::normalize(direction);
      const double expected = nearest(facets, origin, direction, false);
      const FacetGrid::Hit hit = grid.first_hit(origin, direction);
      const bool found = hit.facet != FacetGrid::kNone;
      ASSERT_EQ(found, std::isfinite(expected)) << count << " facets, ray " << i;
      ASSERT_EQ(grid.is_blocked(origin, direction), std::isfinite(nearest(facets, origin, direction, true)));
      if (!found) continue;
      ++hits;
      const vec3 at = origin + direction * static_cast<float>(expected);
      EXPECT_NEAR(hit.point.z, at.z, 2e-5f);
      EXPECT_NEAR(std::remainder(hit.point.x - at.x, 1.0f), 0, 2e-5f);
      EXPECT_NEAR(std::remainder(hit.point.y - at.y, 1.0f), 0, 2e-5f);
    }
  }
  EXPECT_GT(hits, 100);
}

TEST(FacetGrid, LetsNoRaySlipThroughAClosedSurface) {
  const FacetGrid grid(test::bumps(64, 0.5f, false).facets);
  Random random(3);
  for (int i = 0; i < 200000; ++i) {
    // Through corners and along edges too.
    const float cells = i % 2 == 0 ? 64.0f : 1e9f;
    const vec3 at(std::floor(random.next() * cells) / cells, std::floor(random.next() * cells) / cells, 0.2f);
    const float angle = random.next() * 6.2831853f, tilt = random.next() * 1.4f;
    const vec3 direction(std::cos(angle) * std::sin(tilt), std::sin(angle) * std::sin(tilt), -std::cos(tilt));
    ASSERT_NE(grid.first_hit(at, direction).facet, FacetGrid::kNone) << i;
  }
}

TEST(FacetGrid, LevelRaysAndRaysAboveTheLayerEnd) {
  const FacetGrid grid(test::bumps(16, 0.5f, false).facets);
  EXPECT_FALSE(grid.is_blocked({0.5f, 0.5f, grid.top() + 1e-4f}, {1, 0, 0}));
  EXPECT_FALSE(grid.is_blocked({0.5f, 0.5f, grid.top() + 1}, {0.7f, 0.7f, 0}));
  EXPECT_FALSE(grid.is_blocked({0.5f, 0.5f, grid.top() + 1}, {0, 0, 1}));
  EXPECT_TRUE(grid.is_blocked({0.5f, 0.5f, grid.top() + 1}, {0, 0, -1}));
  EXPECT_TRUE(grid.is_blocked({0.5f, 0.5f, 0.5f * (grid.top() + grid.bottom())}, {1, 0, 0}));
}

TEST(FacetGrid, FacetsWithoutAnAreaAreLeftOut) {
  std::vector<Facet> facets = test::plane(4, 0.5f).facets;
  facets.push_back({{vec3(0.1f), vec3(0.1f), vec3(0.4f)}});
  EXPECT_EQ(FacetGrid(facets).facets().size(), FacetGrid(test::plane(4, 0.5f).facets).facets().size());
}

}  // namespace
}  // namespace vamp::acquire
