// The tree once more as a list with skips, for rays that ask only whether anything is in the way.
#include <utility>

#include "engine/accel/bvh.h"
#include "engine/accel/bvh_box.h"
#include "shaders/shared/intersect.h"

namespace vamp {
namespace {

// The larger child first: it is the likelier to hold what is in the way.
void append(Bvh& bvh, size_t node) {
  size_t children[2] = {2 * node, 2 * node + 1};
  if (half_area(bvh.nodes[children[0]], bvh.grid_scale) < half_area(bvh.nodes[children[1]], bvh.grid_scale))
    std::swap(children[0], children[1]);
  for (const size_t child : children) {
    const size_t at = bvh.list.size();
    bvh.list.push_back(bvh.nodes[child]);
    bvh.list_box.push_back(static_cast<uint32_t>(child));
    const int32_t inside = static_cast<int32_t>(bvh.nodes[child].w);
    if (inside < 0) continue;
    append(bvh, static_cast<size_t>(inside));
    bvh.list[at].w = static_cast<uint32_t>(bvh.list.size());
  }
}

}  // namespace

void make_list(Bvh& bvh) {
  bvh.list.clear();
  bvh.list_box.clear();
  bvh.list.reserve(bvh.nodes.size() + BVH_LIST_ENDS);
  bvh.list_box.reserve(bvh.nodes.size());
  append(bvh, 0);
  for (int i = 0; i < BVH_LIST_ENDS; ++i) bvh.list.push_back(pack_box({uvec3(0), uvec3(65535)}, BVH_DONE));
}

}  // namespace vamp
