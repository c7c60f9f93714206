// A tree whose triangles have moved and whose boxes were made to fit again: rays must hit what they hit in a tree made
// anew, without a tree, and in Embree.
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "bench/embree_scene.h"
#include "engine/accel/bvh.h"
#include "engine/scene/placement.h"
#include "tests/accel/meshes.h"
#include "tests/accel/tree_checks.h"

namespace vamp {
namespace {

Bvh build(const TestMesh& mesh) { return build_bvh(mesh.positions, mesh.triangles); }

// As who moves parts writes them.
void put_triangles(const TestMesh& mesh, Bvh& bvh) {
  for (size_t slot = 0; slot < bvh.triangle_count(); ++slot)
    for (int k = 0; k < 3; ++k)
      bvh.triangles[3 * slot + static_cast<size_t>(k)] =
          vec4(mesh.positions[mesh.triangles[bvh.order[slot]][k]], bvh.triangles[3 * slot + static_cast<size_t>(k)].w);
}

// Balls through each other over a floor; the part that moves is cut out of the first of them, triangle by triangle.
struct Shoe {
  TestMesh mesh;
  std::vector<vec3> rest;  // positions as built
  size_t first = 0;        // of the positions that move

  explicit Shoe(uint32_t rings) {
    TestMesh ball;
    ball.add_sphere(vec3(0), 1.0f, rings, 0.1f);
    mesh.add_grid(vec3(-3, -1.2f, -3), vec3(0, 0, 6), vec3(6, 0, 0), 3, 3);
    mesh.add_sphere(vec3(0.7f, 0.2f, -0.4f), 0.6f, rings, 0.1f);
    for (size_t pass = 0; pass < 2; ++pass) {
      if (pass == 1) first = mesh.positions.size();
      for (size_t i = 0; i < ball.triangles.size(); ++i) {
        const uvec3 t = ball.triangles[i];
        if (i / 5 % 2 == pass) mesh.add(ball.positions[t.x], ball.positions[t.y], ball.positions[t.z]);
      }
    }
    rest = mesh.positions;
  }
  void move(const Placement& place) {
    const RigidMotion motion(place, vec3(0));
    for (size_t i = first; i < rest.size(); ++i) mesh.positions[i] = motion.point(rest[i]);
  }
};

// From far and near, towards triangles and anywhere.
struct RandomRay {
  vec3 origin, direction;
  RandomRay(const TestMesh& mesh, std::mt19937& random) {
    const uvec3 t = mesh.triangles[random() % mesh.triangles.size()];
    const vec3 target = (mesh.positions[t.x] + mesh.positions[t.y] + mesh.positions[t.z]) / 3.0f;
    origin = target + random_direction(random) * (0.01f + static_cast<float>(random() % 1000) * 0.01f);
    direction = random() % 3 == 0 ? random_direction(random) : glm::normalize(target - origin);
  }
};

// Two triangles may be hit in one place: then either will do.
void expect_same(const std::optional<Hit>& expected, const std::optional<Hit>& found) {
  ASSERT_EQ(expected.has_value(), found.has_value());
  if (expected) {
    ASSERT_EQ(expected->t, found->t);
  }
}

Placement random_placement(std::mt19937& random) {
  const float reach[] = {0.001f, 0.1f, 1, 30};
  Placement place;
  place.offset = random_point(random, vec3(-1), vec3(1)) * reach[random() % 4];
  if (random() % 2 == 0) place.turn = random_point(random, vec3(-3), vec3(3));
  return place;
}

TEST(Refit, OfWhatHasNotMovedChangesNothing) {
  Shoe shoe(40);
  const Bvh bvh = build(shoe.mesh);
  Bvh again = bvh;
  refit_bvh(again);
  EXPECT_EQ(again.nodes, bvh.nodes);
  EXPECT_EQ(again.list, bvh.list);
  EXPECT_EQ(again.bounds, bvh.bounds);
}

TEST(Refit, RaysHitWhatTheyHitWithoutATreeAndInANewOne) {
  std::mt19937 random(2026);
  Shoe shoe(12);
  Bvh bvh = build(shoe.mesh);
  int hits = 0;
  for (int round = 0; round < 40; ++round) {
    SCOPED_TRACE(round);
    shoe.move(random_placement(random));
    put_triangles(shoe.mesh, bvh);
    refit_bvh(bvh);
    expect_valid(bvh);
    const Bvh remade = build(shoe.mesh);
    EXPECT_EQ(bvh.bounds, remade.bounds);
    EXPECT_EQ(bvh.grid_scale, remade.grid_scale);
    for (int i = 0; i < 1000; ++i) {
      const RandomRay ray(shoe.mesh, random);
      const std::optional<Hit> found = pick(bvh, ray.origin, ray.direction);
      expect_same(pick_without_tree(shoe.mesh, ray.origin, ray.direction), found);
      expect_same(pick(remade, ray.origin, ray.direction), found);
      ASSERT_EQ(occluded(bvh, ray.origin, ray.direction, 0, 3.4e38f), found.has_value());
      hits += found ? 1 : 0;
    }
  }
  EXPECT_GT(hits, 20000);
}

TEST(Refit, EmbreeSeesTheSameInAFinerScene) {
  std::mt19937 random(7);
  Shoe shoe(60);
  Bvh bvh = build(shoe.mesh);
  for (int round = 0; round < 3; ++round) {
    shoe.move(random_placement(random));
    put_triangles(shoe.mesh, bvh);
    refit_bvh(bvh);
    const EmbreeScene embree(shoe.mesh.positions, shoe.mesh.triangles, EmbreeScene::Edges::watertight);
    int different = 0;
    constexpr int kRays = 30000;
    for (int i = 0; i < kRays; ++i) {
      const RandomRay ray(shoe.mesh, random);
      const EmbreeScene::Hit expected = embree.nearest(ray.origin, ray.direction);
      const std::optional<Hit> found = pick(bvh, ray.origin, ray.direction);
      const bool same = (expected.triangle >= 0) == found.has_value() &&
                        (!found || std::abs(found->t - expected.distance) <= 1e-4f * std::max(expected.distance, 0.1f));
      different += same ? 0 : 1;
    }
    EXPECT_LE(different, kRays / 10000);
  }
}

TEST(Refit, BringsTheTreeBackBitForBit) {
  std::mt19937 random(5);
  Shoe shoe(20);
  const Bvh bvh = build(shoe.mesh);
  Bvh moved = bvh;
  for (int i = 0; i < 5; ++i) {
    shoe.move(random_placement(random));
    put_triangles(shoe.mesh, moved);
    refit_bvh(moved);
  }
  EXPECT_NE(moved.nodes, bvh.nodes);
  shoe.move({});
  put_triangles(shoe.mesh, moved);
  refit_bvh(moved);
  EXPECT_EQ(moved.nodes, bvh.nodes);
  EXPECT_EQ(moved.list, bvh.list);
  EXPECT_EQ(moved.triangles, bvh.triangles);
}

TEST(Refit, CostGrowsWhereNeighboursPartAndNotWhereAWholeThingLeaves) {
  Shoe shoe(40);
  Bvh bvh = build(shoe.mesh);
  const double rest = box_cost(bvh);
  shoe.move({vec3(0, 1, 0), {}});
  put_triangles(shoe.mesh, bvh);
  refit_bvh(bvh);
  EXPECT_GT(box_cost(bvh), 2 * rest);
  EXPECT_LT(box_cost(build(shoe.mesh)), 1.5 * rest);

  TestMesh two;
  two.add_sphere(vec3(-2, 0, 0), 1, 30, 0.1f);
  const size_t first = two.positions.size();
  two.add_sphere(vec3(2, 0, 0), 1, 30, 0.1f);
  Bvh apart = build(two);
  const double together = box_cost(apart);
  for (size_t i = first; i < two.positions.size(); ++i) two.positions[i].x += 20;
  put_triangles(two, apart);
  refit_bvh(apart);
  EXPECT_LT(box_cost(apart), 1.02 * together);
}

TEST(Refit, OfFewOrNoTrianglesIsValid) {
  for (uint32_t n = 0; n <= 6; ++n) {
    TestMesh mesh;
    for (uint32_t i = 0; i < n; ++i) {
      const float x = static_cast<float>(3 * i);
      mesh.add({x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0});
    }
    Bvh bvh = build(mesh);
    for (vec3& p : mesh.positions) p += vec3(100, -3, 5) * static_cast<float>(p.x > 2);
    put_triangles(mesh, bvh);
    refit_bvh(bvh);
    if (n > 0) expect_valid(bvh);
    for (uint32_t i = 0; i < n; ++i) {
      const vec3 corner = mesh.positions[3 * i];
      const auto hit = pick(bvh, corner + vec3(0.25f, 0.25f, 2), vec3(0, 0, -1));
      ASSERT_TRUE(hit);
      EXPECT_EQ(hit->triangle, i);
    }
  }
}

}  // namespace
}  // namespace vamp
