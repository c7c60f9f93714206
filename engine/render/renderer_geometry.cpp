// Where a renderer's triangles stand: what of a project says so, and how its tables follow.
#include <algorithm>

#include "engine/core/check.h"
#include "engine/render/renderer.h"

namespace vamp {

// Which triangles there are.
bool Renderer::geometry_differs(const Project& now) const {
  if (!project_ || now.scene != project_->scene) return true;
  for (size_t i = 0; i < now.parts.size(); ++i)
    if (now.parts[i].visible != project_->parts[i].visible) return true;
  return false;
}

// Where those stand that are seen. The parts are those of the project drawn last.
bool Renderer::parts_moved(const Project& now) const {
  for (size_t i = 0; i < now.parts.size(); ++i)
    if (now.parts[i].visible && now.parts[i].place != project_->parts[i].place) return true;
  return false;
}

// Sends what has changed of the triangles. Whether buffers are new.
Result<bool> Renderer::take_geometry(const Project& now, Change& change) {
  const bool new_scene = geometry_differs(now);
  MovedRows moved;
  if (new_scene)
    placed_.emplace(now);
  else
    moved = placed_->place(now);
  if (!trees_later_ && wants_tree()) placed_->make_tree();
  const bool same_tree = !new_scene && placed_->tables() == scene_tables_;
  scene_tables_ = placed_->tables();
  if (same_tree) {
    change.bytes += gpu_.send_moved(*device_, *scene_tables_, moved);
    return false;
  }
  VAMP_TRY(const uint64_t bytes, gpu_.send_scene(*device_, *scene_tables_, key_.path));
  change.bytes += bytes;
  return true;
}

Status Renderer::make_tree() {
  CHECK(placed_ && !replaying() && std::all_of(samples_.begin(), samples_.end(), [](uint32_t n) { return n == 0; }));
  placed_->make_tree();
  scene_tables_ = placed_->tables();
  const Result<uint64_t> sent = gpu_.send_scene(*device_, *scene_tables_, key_.path);
  if (!sent) {
    project_ = nullptr;
    return tl::unexpected(sent.error());
  }
  if (region_.width > 0) {
    make_descriptor_set();
    send_frame();
  }
  return {};
}

}  // namespace vamp
