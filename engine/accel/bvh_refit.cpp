// Boxes that fit again around triangles that have moved.
#include <cstring>
#include <memory>

#include "engine/accel/bvh.h"
#include "engine/accel/bvh_grid.h"

namespace vamp {
namespace {

Lanes lanes_of(const vec4& v) {
  Lanes lanes;
  std::memcpy(&lanes, &v, sizeof(lanes));
  return lanes;
}

ExactBox box_of_leaf(const Bvh& bvh, int32_t inside) {
  const auto leaf = static_cast<uint32_t>(~inside);
  const vec4* corner = &bvh.triangles[3 * static_cast<size_t>(leaf >> 3)];
  const vec4* const end = corner + 3 * static_cast<size_t>((leaf & 7u) + 1);
  ExactBox box = ExactBox::empty();
  for (; corner != end; ++corner) box.extend(lanes_of(*corner));
  return box;
}

}  // namespace

void refit_bvh(Bvh& bvh) {
  if (bvh.triangle_count() == 0) return;
  // From the leaves up: what is in a node stands behind it.
  const auto boxes = std::make_unique_for_overwrite<ExactBox[]>(bvh.nodes.size());
  for (size_t i = bvh.nodes.size(); i-- > 0;) {
    const auto inside = static_cast<int32_t>(bvh.nodes[i].w);
    if (inside < 0) {
      boxes[i] = box_of_leaf(bvh, inside);
    } else {
      boxes[i] = boxes[2 * static_cast<size_t>(inside)];
      boxes[i].extend(boxes[2 * static_cast<size_t>(inside) + 1]);
    }
  }
  ExactBox root = boxes[0];
  root.extend(boxes[1]);
  bvh.bounds = root.bounds();

  const Grid grid(bvh.bounds);
  bvh.grid_origin = grid.origin;
  bvh.grid_scale = grid.scale;
  for (size_t i = 0; i < bvh.nodes.size(); ++i)
    bvh.nodes[i] = grid.child(boxes[i], static_cast<int32_t>(bvh.nodes[i].w));
  for (size_t i = 0; i < bvh.list_end(); ++i) {
    const uvec4& box = bvh.nodes[bvh.list_box[i]];
    bvh.list[i] = uvec4(box.x, box.y, box.z, bvh.list[i].w);
  }
}

}  // namespace vamp
