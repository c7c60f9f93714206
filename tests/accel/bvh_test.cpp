// The tree must be valid and hit what is there for every input, however unpleasant (the list follows embree's
// tutorials/verify: degenerate, coincident, flat, far away, slivers).
#include "engine/accel/bvh.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

#include "engine/accel/bvh_box.h"
#include "shaders/shared/intersect.h"
#include "tests/accel/meshes.h"

namespace vamp {
namespace {

Bvh build(const TestMesh& mesh) { return build_bvh(mesh.positions, mesh.triangles); }

// Every triangle stands in exactly one leaf (a single one twice), inside all boxes above it with a quarter of a cell to
// spare; the depth is what the tree says and fits the stack.
class Validator {
 public:
  explicit Validator(const Bvh& bvh) : bvh_(bvh), seen_(bvh.triangle_count(), 0) {}

  void run() {
    visit(0, {uvec3(0), uvec3(65535)}, 1);
    check_list();
    EXPECT_EQ(deepest_, bvh_.depth);
    EXPECT_LT(bvh_.depth, static_cast<uint32_t>(BVH_STACK_SIZE));
    const int times = seen_.size() == 1 ? 2 : 1;
    EXPECT_TRUE(std::all_of(seen_.begin(), seen_.end(), [&](int n) { return n == times; }));
    std::vector<uint32_t> order = bvh_.order;
    std::sort(order.begin(), order.end());
    std::vector<uint32_t> all(order.size());
    std::iota(all.begin(), all.end(), 0u);
    EXPECT_EQ(order, all);
  }

 private:
  void visit(size_t node, const GridBox& above, uint32_t depth) {
    ASSERT_LT(2 * node + 1, bvh_.nodes.size());
    deepest_ = std::max(deepest_, depth);
    for (size_t side = 0; side < 2; ++side) {
      const uvec4& child = bvh_.nodes[2 * node + side];
      const GridBox box = unpack_box(child);
      for (int k = 0; k < 3; ++k) {
        ASSERT_GE(box.lo[k], above.lo[k]);
        ASSERT_LE(box.hi[k], above.hi[k]);
      }
      const int reference = static_cast<int>(child.w);
      if (reference >= 0) {
        ASSERT_GT(static_cast<size_t>(reference), node);
        visit(static_cast<size_t>(reference), box, depth + 1);
      } else {
        check_leaf(static_cast<uint32_t>(~reference), box);
      }
    }
  }

  // The list holds the boxes of the nodes; who misses a box goes on behind all that is in it, and it ends.
  void check_list() {
    ASSERT_EQ(bvh_.list.size(), bvh_.list_end() + BVH_LIST_ENDS);
    std::vector<size_t> ends;
    for (size_t at = 0; at < bvh_.list_end(); ++at) {
      while (!ends.empty() && ends.back() == at) ends.pop_back();
      const int inside = static_cast<int>(bvh_.list[at].w);
      if (inside < 0) continue;
      ASSERT_GT(static_cast<size_t>(inside), at + 1);
      ASSERT_LE(static_cast<size_t>(inside), ends.empty() ? bvh_.list_end() : ends.back());
      ends.push_back(static_cast<size_t>(inside));
    }
    for (size_t at = bvh_.list_end(); at < bvh_.list.size(); ++at)
      ASSERT_EQ(static_cast<int>(bvh_.list[at].w), BVH_DONE);
    const auto boxes = [](std::vector<uvec4> rows) {
      std::vector<std::array<uint32_t, 3>> all;
      for (const uvec4& row : rows) all.push_back({row.x, row.y, row.z});
      std::sort(all.begin(), all.end());
      return all;
    };
    EXPECT_EQ(boxes(bvh_.nodes), boxes({bvh_.list.begin(), bvh_.list.begin() + static_cast<long>(bvh_.list_end())}));
  }

  void check_leaf(uint32_t leaf, const GridBox& box) {
    const uint32_t first = leaf >> 3;
    const uint32_t last = first + (leaf & 7u);
    ASSERT_LE((leaf & 7u) + 1, 4u);
    ASSERT_LT(last, seen_.size());
    for (uint32_t i = first; i <= last; ++i) {
      ++seen_[i];
      for (size_t corner = 0; corner < 3; ++corner)
        for (int k = 0; k < 3; ++k) {
          const double place =
              (static_cast<double>(bvh_.triangles[3 * i + corner][k]) - static_cast<double>(bvh_.grid_origin[k])) /
              static_cast<double>(bvh_.grid_scale[k]);
          ASSERT_GE(place, box.lo[k] + 0.2499);
          ASSERT_LE(place, box.hi[k] + box.lo[k] / 65536.0 - 0.2499);
        }
    }
  }

  const Bvh& bvh_;
  std::vector<int> seen_;
  uint32_t deepest_ = 0;
};

void expect_valid(const Bvh& bvh) { Validator(bvh).run(); }

// The nearest hit without a tree, in the same arithmetic.
std::optional<Hit> pick_without_tree(const TestMesh& mesh, const vec3& origin, const vec3& direction) {
  std::optional<Hit> nearest;
  float t_max = 3.4e38f;
  for (uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const uvec3 t = mesh.triangles[i];
    const vec4 hit = intersect_triangle(origin, direction, ray_side(direction), ray_above(direction),
                                        mesh.positions[t.x], mesh.positions[t.y], mesh.positions[t.z], 0.0f, t_max);
    if (hit.w > 0) {
      t_max = hit.x;
      nearest = Hit{i, hit.x, hit.y, hit.z};
    }
  }
  return nearest;
}

// Rays from around the mesh towards points on it, compared with the search through all triangles.
void expect_same_as_without_tree(const TestMesh& mesh, int rays, float distance, uint32_t seed) {
  const Bvh bvh = build(mesh);
  expect_valid(bvh);
  std::mt19937 random(seed);
  int hits = 0;
  for (int i = 0; i < rays; ++i) {
    const uvec3 t = mesh.triangles[random() % mesh.triangles.size()];
    const vec3 b = random_point(random, vec3(0), vec3(1));
    const float sum = std::max(b.x + b.y + b.z, 1e-6f);
    const vec3 target =
        mesh.positions[t.x] * (b.x / sum) + mesh.positions[t.y] * (b.y / sum) + mesh.positions[t.z] * (b.z / sum);
    const vec3 origin = target + random_direction(random) * distance;
    const vec3 direction = glm::normalize(target - origin);
    const std::optional<Hit> expected = pick_without_tree(mesh, origin, direction);
    const std::optional<Hit> found = pick(bvh, origin, direction);
    ASSERT_EQ(expected.has_value(), found.has_value()) << "ray " << i;
    EXPECT_EQ(occluded(bvh, origin, direction, 0, 3.4e38f), expected.has_value());
    if (!expected) continue;
    ++hits;
    ASSERT_EQ(expected->t, found->t) << "ray " << i;
  }
  EXPECT_GT(hits, rays / 2);
}

TEST(Bvh, NoTrianglesGiveATreeThatNothingHits) {
  const Bvh bvh = build_bvh({}, {});
  EXPECT_EQ(bvh.triangle_count(), 0u);
  EXPECT_EQ(bvh.nodes.size(), 2u);
  EXPECT_FALSE(pick(bvh, vec3(0, 0, 5), vec3(0, 0, -1)));
  EXPECT_FALSE(pick(bvh, vec3(0), vec3(0, 0, -1)));
  EXPECT_EQ(sah_cost(bvh), 0);
}

TEST(Bvh, OneToTenTrianglesAreEachFound) {
  for (uint32_t n = 1; n <= 10; ++n) {
    TestMesh mesh;
    for (uint32_t i = 0; i < n; ++i) {
      const float x = static_cast<float>(3 * i);
      mesh.add({x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0});
    }
    const Bvh bvh = build(mesh);
    expect_valid(bvh);
    for (uint32_t i = 0; i < n; ++i) {
      const auto hit = pick(bvh, vec3(static_cast<float>(3 * i) + 0.25f, 0.5f, 2), vec3(0, 0, -1));
      ASSERT_TRUE(hit);
      EXPECT_EQ(hit->triangle, i);
      EXPECT_FLOAT_EQ(hit->t, 2);
      EXPECT_FLOAT_EQ(hit->u, 0.25f);
      EXPECT_FLOAT_EQ(hit->v, 0.5f);
    }
  }
}

TEST(Bvh, IdenticalTrianglesKeepTheDepthBounded) {
  TestMesh mesh;
  for (int i = 0; i < 5000; ++i) mesh.add({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  const Bvh bvh = build(mesh);
  expect_valid(bvh);
  EXPECT_LE(bvh.depth, 13u);
  const auto hit = pick(bvh, vec3(0.2f, 0.2f, 1), vec3(0, 0, -1));
  ASSERT_TRUE(hit);
  EXPECT_FLOAT_EQ(hit->t, 1);
}

TEST(Bvh, AHundredThousandCoincidentCentroidsAreSplitByMedian) {
  TestMesh mesh;
  std::mt19937 random(7);
  for (int i = 0; i < 100000; ++i) {
    const vec3 e = random_direction(random) * 0.5f;
    // The box is symmetrical about the origin, so that all centroids coincide.
    mesh.add(e, -e, vec3(-e.x, e.y, -e.z));
  }
  const Bvh bvh = build(mesh);
  expect_valid(bvh);
  EXPECT_LE(bvh.depth, 18u);
}

TEST(Bvh, ExponentiallyShrinkingTrianglesDoNotOverflowTheStack) {
  TestMesh mesh;
  for (int i = 0; i < 120; ++i) {
    const float s = std::pow(0.5f, static_cast<float>(i));
    for (int j = 0; j < 6; ++j) mesh.add({s, 0, 0}, {s * 1.1f, 0, 0}, {s, s * 0.1f, 0});
  }
  expect_valid(build(mesh));
}

TEST(Bvh, TrianglesWithoutAreaAreNeverHit) {
  TestMesh mesh;
  for (int i = 0; i < 100; ++i) {
    const float x = static_cast<float>(i);
    mesh.add({x, 0, 0}, {x, 0, 0}, {x, 0, 0});
    mesh.add({x, 0, 0}, {x + 1, 0, 0}, {x + 2, 0, 0});
  }
  const Bvh bvh = build(mesh);
  expect_valid(bvh);
  for (int i = 0; i < 100; ++i) EXPECT_FALSE(pick(bvh, vec3(static_cast<float>(i), 0, 1), vec3(0, 0, -1)));
}

TEST(Bvh, FlatScenesAreHitFromEverySide) {
  const vec3 axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (size_t k = 0; k < 3; ++k) {
    TestMesh mesh;
    mesh.add_grid(vec3(0), axes[(k + 1) % 3], axes[(k + 2) % 3], 30, 30);
    expect_same_as_without_tree(mesh, 2000, 3.0f, 11);
    // Straight down the normal, where two direction components are exactly zero.
    const Bvh bvh = build(mesh);
    const vec3 middle = (axes[(k + 1) % 3] + axes[(k + 2) % 3]) * 0.5f;
    const auto hit = pick(bvh, middle + axes[k] * 2.0f, -axes[k]);
    ASSERT_TRUE(hit);
    EXPECT_FLOAT_EQ(hit->t, 2);
  }
}

TEST(Bvh, AScenePlacedAMillionUnitsAwayIsHit) {
  TestMesh mesh;
  mesh.add_sphere(vec3(1e6f, -1e6f, 1e6f), 10.0f, 40);
  expect_same_as_without_tree(mesh, 3000, 30.0f, 12);
}

TEST(Bvh, AFarCameraMissesNothing) {
  TestMesh mesh;
  mesh.add_sphere(vec3(0), 1.0f, 40);
  expect_same_as_without_tree(mesh, 3000, 2000.0f, 13);
}

TEST(Bvh, HugeBesideTinyTrianglesAreBothHit) {
  TestMesh mesh;
  mesh.add_grid(vec3(-1e5f, 0, -1e5f), vec3(2e5f, 0, 0), vec3(0, 0, 2e5f), 1, 1);
  mesh.add_sphere(vec3(0, 0.2f, 0), 0.1f, 20);
  expect_same_as_without_tree(mesh, 3000, 0.5f, 14);
}

TEST(Bvh, SliversAreFoundLikeWithoutATree) {
  TestMesh mesh;
  for (int i = 0; i < 400; ++i) {
    const float a = static_cast<float>(i) * 0.0157f;
    mesh.add({0, 0, 0}, {std::cos(a), std::sin(a), 0.3f}, {std::cos(a + 1e-5f), std::sin(a + 1e-5f), 0.3f});
  }
  const Bvh bvh = build(mesh);
  expect_valid(bvh);
  std::mt19937 random(15);
  for (int i = 0; i < 2000; ++i) {
    const vec3 origin = random_direction(random) * 2.0f;
    const vec3 direction = random_direction(random);
    const auto expected = pick_without_tree(mesh, origin, direction);
    const auto found = pick(bvh, origin, direction);
    ASSERT_EQ(expected.has_value(), found.has_value());
  }
}

TEST(Bvh, SmallScenesInThousandthsOfAUnitAreHit) {
  TestMesh mesh;
  mesh.add_sphere(vec3(1e-4f), 1e-4f, 30, 0.1f);
  expect_same_as_without_tree(mesh, 2000, 1e-3f, 16);
}

TEST(Bvh, RaysInsideAClosedSphereNeverLeak) {
  TestMesh mesh;
  mesh.add_sphere(vec3(0.3f, -0.2f, 0.1f), 1.0f, 50, 0.05f);
  const Bvh bvh = build(mesh);
  std::mt19937 random(17);
  // Half of the rays go exactly at vertices and edge middles, where tests that are not watertight leak.
  for (int i = 0; i < 100000; ++i) {
    const vec3 origin = vec3(0.3f, -0.2f, 0.1f) + random_direction(random) * 0.3f;
    vec3 direction = random_direction(random);
    if (i % 2 == 0) {
      const uvec3 t = mesh.triangles[random() % mesh.triangles.size()];
      const vec3 p = i % 4 == 0 ? mesh.positions[t.x] : (mesh.positions[t.x] + mesh.positions[t.y]) * 0.5f;
      direction = glm::normalize(p - origin);
    }
    ASSERT_TRUE(pick(bvh, origin, direction)) << "ray " << i;
  }
}

TEST(Bvh, RangeOfTheRayIsRespected) {
  TestMesh mesh;
  mesh.add({-1, -1, 0}, {1, -1, 0}, {0, 1, 0});
  mesh.add({-1, -1, -2}, {1, -1, -2}, {0, 1, -2});
  const Bvh bvh = build(mesh);
  const vec3 origin(0, 0, 3);
  const vec3 down(0, 0, -1);
  EXPECT_EQ(pick(bvh, origin, down)->triangle, 0u);
  EXPECT_EQ(pick(bvh, origin, down, 3.5f)->triangle, 1u);
  EXPECT_FALSE(pick(bvh, origin, down, 3.5f, 4.5f));
  EXPECT_FALSE(occluded(bvh, origin, down, 0, 2.9f));
  EXPECT_TRUE(occluded(bvh, origin, down, 0, 3.1f));
  EXPECT_FALSE(pick(bvh, origin, -down));
}

TEST(Bvh, TheSameInputGivesTheSameBytes) {
  TestMesh mesh;
  mesh.add_sphere(vec3(0), 1.0f, 130, 0.1f);  // enough triangles for several threads
  const Bvh a = build(mesh);
  const Bvh b = build(mesh);
  EXPECT_EQ(a.nodes, b.nodes);
  EXPECT_EQ(a.order, b.order);
}

TEST(Bvh, PartAndFlagsStandBesideTheVertices) {
  TestMesh mesh;
  mesh.add({0, 0, 0}, {1, 0, 0}, {0, 1, 0});
  mesh.add({5, 0, 0}, {6, 0, 0}, {5, 1, 0});
  const std::vector<uint32_t> parts = {0, 1};
  const std::vector<uint32_t> flags = {0, TRIANGLE_ALPHA_MASK | TRIANGLE_DOUBLE_SIDED};
  const Bvh bvh = build_bvh(mesh.positions, mesh.triangles, parts, flags);
  for (size_t i = 0; i < 2; ++i) {
    const uint32_t scene_triangle = bvh.order[i];
    EXPECT_EQ(bvh.triangles[3 * i].w, static_cast<float>(parts[scene_triangle]));
    EXPECT_EQ(bvh.triangles[3 * i + 1].w, static_cast<float>(flags[scene_triangle]));
  }
}

TEST(Bvh, CostIsFarBelowAListOfTriangles) {
  TestMesh mesh;
  mesh.add_sphere(vec3(0), 1.0f, 60, 0.1f);
  const double cost = sah_cost(build(mesh));
  EXPECT_GT(cost, 1.0);
  EXPECT_LT(cost, 60.0);  // 14 k triangles
}

}  // namespace
}  // namespace vamp
