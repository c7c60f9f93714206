// The tree once more as a list with skips, for rays that ask only whether anything is in the way.
#include <utility>

#include "engine/accel/bvh.h"
#include "engine/accel/bvh_box.h"
#include "shaders/shared/intersect.h"

namespace vamp {
namespace {

// The larger child first: it is the likelier to hold what is in the way.
void append(const Bvh& bvh, size_t node, std::vector<uvec4>& list) {
  uvec4 children[2] = {bvh.nodes[2 * node], bvh.nodes[2 * node + 1]};
  if (half_area(children[0], bvh.grid_scale) < half_area(children[1], bvh.grid_scale))
    std::swap(children[0], children[1]);
  for (const uvec4& child : children) {
    const size_t at = list.size();
    list.push_back(child);
    const int32_t inside = static_cast<int32_t>(child.w);
    if (inside < 0) continue;
    append(bvh, static_cast<size_t>(inside), list);
    list[at].w = static_cast<uint32_t>(list.size());
  }
}

}  // namespace

std::vector<uvec4> list_of(const Bvh& bvh) {
  std::vector<uvec4> list;
  list.reserve(bvh.nodes.size() + BVH_LIST_ENDS);
  append(bvh, 0, list);
  for (int i = 0; i < BVH_LIST_ENDS; ++i) list.push_back(pack_box({uvec3(0), uvec3(65535)}, BVH_DONE));
  return list;
}

}  // namespace vamp
