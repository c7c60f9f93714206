#include "tests/accel/tree_checks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <numeric>

#include "engine/accel/bvh_box.h"
#include "shaders/shared/intersect.h"

namespace vamp {
namespace {

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

}  // namespace

void expect_valid(const Bvh& bvh) { Validator(bvh).run(); }

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

}  // namespace vamp
