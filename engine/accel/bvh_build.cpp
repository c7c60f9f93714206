#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cmath>
#include <future>
#include <limits>
#include <thread>

#include "engine/accel/bvh.h"
#include "engine/accel/bvh_grid.h"
#include "engine/core/check.h"
#include "engine/scene/scene.h"
#include "shaders/shared/intersect.h"

namespace vamp {
namespace {

constexpr int kBins = 16;
constexpr uint32_t kLeafSize = 4;
constexpr int kMaxDepth = BVH_STACK_SIZE - 1;
constexpr uint32_t kParallelSize = 40000;  // below this a task costs more than it saves

constexpr float kInfinity = std::numeric_limits<float>::infinity();

// A triangle while it is being sorted into the tree.
struct Item {
  ExactBox box = ExactBox::empty();
  Lanes centroid;  // lo + hi: twice the centre
  uint32_t triangle;
};

struct BuildNode {
  ExactBox box = ExactBox::empty();
  uint32_t first = 0, count = 0;  // count > 0: a leaf
  uint32_t left = 0, right = 0;
};

struct Split {
  int axis = -1;
  int bin = 0;
  float cost = kInfinity;
};

// How many more levels `count` triangles need when every split halves them.
int levels_needed(uint32_t count) {
  return count <= kLeafSize ? 0 : std::bit_width((count + kLeafSize - 1) / kLeafSize - 1);
}

class Builder {
 public:
  Builder(std::vector<Item>& items, int threads) : items_(items), nodes_(2 * items.size()), spare_(threads - 1) {}

  void build() {
    next_ = 1;
    build_node(0, 0, static_cast<uint32_t>(items_.size()), 0);
  }
  const std::vector<BuildNode>& nodes() const { return nodes_; }

 private:
  void build_node(uint32_t index, uint32_t first, uint32_t count, int depth) {
    BuildNode& node = nodes_[index];
    ExactBox centroids = ExactBox::empty();
    for (uint32_t i = first; i < first + count; ++i) {
      node.box.extend(items_[i].box);
      centroids.extend(items_[i].centroid);
    }
    // The median halves, so it is taken as soon as nothing else would keep the tree within the stack of the kernels.
    const bool only_median = levels_needed(count) >= kMaxDepth - depth;
    const Split split = only_median ? Split{} : best_split(first, count, centroids);
    // Costs in ray-triangle tests; a step down costs as much as one.
    const float leaf_cost = static_cast<float>(count) * node.box.half_area();
    if (count <= kLeafSize && (count == 1 || split.axis < 0 || split.cost + node.box.half_area() >= leaf_cost)) {
      node.first = first;
      node.count = count;
      return;
    }
    const uint32_t middle =
        split.axis < 0 ? median(first, count, centroids) : partition(first, count, centroids, split);
    node.left = next_.fetch_add(2);
    node.right = node.left + 1;
    const uint32_t left = node.left;
    const auto build_left = [=, this] { build_node(left, first, middle - first, depth + 1); };
    if (count > kParallelSize && take_thread()) {
      std::future<void> other = std::async(std::launch::async, build_left);
      build_node(left + 1, middle, first + count - middle, depth + 1);
      other.get();
      ++spare_;
    } else {
      build_left();
      build_node(left + 1, middle, first + count - middle, depth + 1);
    }
  }

  bool take_thread() {
    if (spare_.fetch_sub(1) > 0) return true;
    ++spare_;
    return false;
  }

  // Bins of centroids: bin = (centroid - lo) * scale, the same arithmetic when counting and when partitioning.
  static Lanes bin_scale(const ExactBox& centroids) {
    Lanes scale = {};
    for (int k = 0; k < 3; ++k) {
      const float size = centroids.hi[k] - centroids.lo[k];
      const float s = static_cast<float>(kBins) * 0.9999f / size;
      scale[k] = size > 0 && std::isfinite(s) ? s : 0.0f;
    }
    return scale;
  }
  static int bin_of(const Item& item, const ExactBox& centroids, Lanes scale, int axis) {
    const Lanes place = (item.centroid - centroids.lo) * scale;
    return std::min(static_cast<int>(place[axis]), kBins - 1);
  }

  Split best_split(uint32_t first, uint32_t count, const ExactBox& centroids) const {
    const Lanes scale = bin_scale(centroids);
    std::array<std::array<ExactBox, kBins>, 3> boxes;
    for (auto& along : boxes) along.fill(ExactBox::empty());
    std::array<std::array<uint32_t, kBins>, 3> counts{};
    for (uint32_t i = first; i < first + count; ++i) {
      const Lanes place = (items_[i].centroid - centroids.lo) * scale;
      for (size_t axis = 0; axis < 3; ++axis) {
        const size_t bin = static_cast<size_t>(std::min(static_cast<int>(place[axis]), kBins - 1));
        boxes[axis][bin].extend(items_[i].box);
        ++counts[axis][bin];
      }
    }
    Split best;
    for (size_t axis = 0; axis < 3; ++axis) {
      if (!(scale[axis] > 0)) continue;
      std::array<float, kBins> right_cost{};
      ExactBox right = ExactBox::empty();
      uint32_t right_count = 0;
      for (size_t bin = kBins - 1; bin > 0; --bin) {
        right.extend(boxes[axis][bin]);
        right_count += counts[axis][bin];
        right_cost[bin] = static_cast<float>(right_count) * right.half_area();
      }
      ExactBox left = ExactBox::empty();
      uint32_t left_count = 0;
      for (size_t bin = 1; bin < kBins; ++bin) {
        left.extend(boxes[axis][bin - 1]);
        left_count += counts[axis][bin - 1];
        if (left_count == 0 || left_count == count) continue;
        const float cost = static_cast<float>(left_count) * left.half_area() + right_cost[bin];
        if (cost < best.cost) best = {static_cast<int>(axis), static_cast<int>(bin), cost};
      }
    }
    return best;
  }

  uint32_t partition(uint32_t first, uint32_t count, const ExactBox& centroids, const Split& split) {
    const Lanes scale = bin_scale(centroids);
    const auto begin = items_.begin() + first;
    const auto middle = std::partition(
        begin, begin + count, [&](const Item& item) { return bin_of(item, centroids, scale, split.axis) < split.bin; });
    return static_cast<uint32_t>(middle - items_.begin());
  }

  uint32_t median(uint32_t first, uint32_t count, const ExactBox& centroids) {
    const Lanes size = centroids.hi - centroids.lo;
    const int axis = size[0] >= size[1] && size[0] >= size[2] ? 0 : (size[1] >= size[2] ? 1 : 2);
    const auto begin = items_.begin() + first;
    std::nth_element(begin, begin + count / 2, begin + count, [&](const Item& a, const Item& b) {
      return a.centroid[axis] != b.centroid[axis] ? a.centroid[axis] < b.centroid[axis] : a.triangle < b.triangle;
    });
    return first + count / 2;
  }

  std::vector<Item>& items_;
  std::vector<BuildNode> nodes_;
  std::atomic<uint32_t> next_{1};
  std::atomic<int> spare_;
};

int32_t leaf_reference(uint32_t first, uint32_t count) { return ~static_cast<int32_t>(first << 3 | (count - 1)); }

// Writes the tree depth-first, so that the layout does not depend on how threads raced.
class Flattener {
 public:
  Flattener(const std::vector<BuildNode>& nodes, const Grid& grid, Bvh& bvh) : nodes_(nodes), grid_(grid), bvh_(bvh) {}

  void flatten_root(uint32_t count) {
    const BuildNode& root = nodes_[0];
    if (root.count == 0) {
      flatten(root, 1);
      return;
    }
    // So few triangles that the root would be a leaf: both children show them, half each; a single one stands twice.
    const uint32_t left = std::max(count / 2, 1u);
    const uint32_t right = std::max(count - left, 1u);
    bvh_.nodes = {grid_.child(root.box, leaf_reference(0, left)),
                  grid_.child(root.box, leaf_reference(count - right, right))};
    bvh_.depth = 1;
  }

 private:
  void flatten(const BuildNode& node, uint32_t depth) {
    const size_t at = bvh_.nodes.size();
    bvh_.nodes.resize(at + 2);
    bvh_.depth = std::max(bvh_.depth, depth);
    write(at, nodes_[node.left], depth);
    write(at + 1, nodes_[node.right], depth);
  }
  void write(size_t at, const BuildNode& child, uint32_t depth) {
    const int32_t reference =
        child.count > 0 ? leaf_reference(child.first, child.count) : static_cast<int32_t>(bvh_.nodes.size() / 2);
    bvh_.nodes[at] = grid_.child(child.box, reference);
    if (child.count == 0) flatten(child, depth + 1);
  }

  const std::vector<BuildNode>& nodes_;
  const Grid& grid_;
  Bvh& bvh_;
};

// A tree that every ray misses: a triangle without area in both leaves.
Bvh empty_bvh() {
  Bvh bvh;
  bvh.triangles.assign(3, vec4(0));
  bvh.nodes.assign(2, pack_box({}, leaf_reference(0, 1)));
  make_list(bvh);
  bvh.depth = 1;
  return bvh;
}

}  // namespace

Bvh build_bvh(std::span<const vec3> positions, std::span<const uvec3> triangles,
              std::span<const uint32_t> triangle_part, std::span<const uint32_t> part_flags) {
  if (triangles.empty()) return empty_bvh();
  CHECK(triangles.size() < (1u << 28) && (triangle_part.empty() || triangle_part.size() == triangles.size()));

  Bvh bvh;
  std::vector<Item> items(triangles.size());
  for (uint32_t i = 0; i < items.size(); ++i) {
    for (int k = 0; k < 3; ++k) {
      CHECK(triangles[i][k] < positions.size());
      const vec3& p = positions[triangles[i][k]];
      CHECK(std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z));
      items[i].box.extend(Lanes{p.x, p.y, p.z, 0.0f});
    }
    items[i].centroid = items[i].box.lo + items[i].box.hi;
    items[i].triangle = i;
  }
  const int threads = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  Builder builder(items, threads);
  builder.build();
  bvh.bounds = builder.nodes()[0].box.bounds();

  const Grid grid(bvh.bounds);
  bvh.grid_origin = grid.origin;
  bvh.grid_scale = grid.scale;
  bvh.nodes.reserve(items.size());
  Flattener(builder.nodes(), grid, bvh).flatten_root(static_cast<uint32_t>(items.size()));
  CHECK(bvh.depth <= kMaxDepth);
  make_list(bvh);

  bvh.order.reserve(items.size());
  bvh.triangles.reserve(3 * items.size());
  for (const Item& item : items) {
    const uvec3 t = triangles[item.triangle];
    const uint32_t part = triangle_part.empty() ? 0 : triangle_part[item.triangle];
    const uint32_t flags = part < part_flags.size() ? part_flags[part] : 0;
    bvh.order.push_back(item.triangle);
    bvh.triangles.emplace_back(positions[t.x], static_cast<float>(part));
    bvh.triangles.emplace_back(positions[t.y], static_cast<float>(flags));
    bvh.triangles.emplace_back(positions[t.z], 0.0f);
  }
  return bvh;
}

std::vector<uint32_t> flags_of_parts(const Scene& scene) {
  std::vector<uint32_t> flags;
  for (const Part& part : scene.parts)
    flags.push_back((part.material.alpha_mode == AlphaMode::mask ? TRIANGLE_ALPHA_MASK : 0u) |
                    (part.material.double_sided ? TRIANGLE_DOUBLE_SIDED : 0u));
  return flags;
}

}  // namespace vamp
