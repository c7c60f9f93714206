#include "engine/render/placed_scene.h"

#include <mutex>

namespace vamp {
namespace {

// From here on a tree is made anew. Most of the sum is a backdrop's, which no move changes: with a shoe's upper a tenth
// of its size away it has grown by 0.002, and a sample takes 7 % longer; at its own size by 0.018, and 2.7 times as
// long
// (`vamp bench edit`). A new tree takes as long as half a sample of the window.
constexpr double kWorse = 1.001;

// Ranges with less than this between them are sent as one.
constexpr uint32_t kGap = 64;

std::vector<bool> visible_parts(const Project& project) {
  std::vector<bool> visible;
  for (const PartState& part : project.parts) visible.push_back(part.visible);
  return visible;
}

}  // namespace

PlacedScene::PlacedScene(const Project& project)
    : scene_(project.scene),
      visible_(visible_parts(project)),
      places_(project.parts.size()),
      motions_(project.parts.size()),
      refitted_(std::make_shared<SceneTables>(build_scene_tables(*scene_, visible_))) {
  rest_cost_ = cost_ = box_cost(refitted_->bvh);
  place(project);
}

MovedRows PlacedScene::place(const Project& project) {
  MovedRows rows;
  remade_.reset();
  std::vector<bool> moved(places_.size()), turned(places_.size());
  bool any = false;
  for (size_t i = 0; i < places_.size(); ++i) {
    const Placement& place = project.parts[i].place;
    if (!visible_[i] || place == places_[i]) continue;
    moved[i] = any = true;
    turned[i] = place.turn != places_[i].turn;
    rows.turned = rows.turned || turned[i];
    places_[i] = place;
    motions_[i] = motion_of(project, i);
  }
  if (!any) return rows;

  const std::unique_lock lock(*refitted_->moving);
  Bvh& bvh = refitted_->bvh;
  for (uint32_t slot = 0; slot < bvh.triangle_count(); ++slot) {
    const uint32_t triangle = bvh.order[slot], part = scene_->triangle_part[triangle];
    if (!moved[part]) continue;
    for (int k = 0; k < 3; ++k) {
      vec4& corner = bvh.triangles[3 * size_t{slot} + static_cast<size_t>(k)];
      corner = vec4(motions_[part].point(scene_->positions[scene_->triangles[triangle][k]]), corner.w);
    }
    if (turned[part]) write_directions(*scene_, triangle, motions_[part], &refitted_->surface[4 * size_t{slot}]);
    if (!rows.triangles.empty() && slot < rows.triangles.back().first + rows.triangles.back().second + kGap)
      rows.triangles.back().second = slot + 1 - rows.triangles.back().first;
    else
      rows.triangles.emplace_back(slot, 1);
  }
  refit_bvh(bvh);
  cost_ = box_cost(bvh);
  return rows;
}

bool PlacedScene::wants_tree() const { return !remade_ && cost_ > kWorse * rest_cost_; }

void PlacedScene::make_tree() {
  remade_ = std::make_shared<SceneTables>(build_triangle_tables(*scene_, visible_, motions_));
  remade_->alpha = refitted_->alpha;
  remade_->alpha_of_part = refitted_->alpha_of_part;
}

}  // namespace vamp
