#include "editor/panels/subject.h"

#include <algorithm>

namespace vamp::ui {

namespace {

constexpr float kBackdrop = 3;
constexpr float kFlat = 0.02f;  // least over largest extent

bool is_flat(const Bounds& bounds) {
  const vec3 size = bounds.size();
  return std::min({size.x, size.y, size.z}) < kFlat * std::max({size.x, size.y, size.z});
}

// Calls `visit` with the bounds of each visible part.
template <class Visit>
void for_each_visible(const Project& project, Visit visit) {
  for (size_t i = 0; i < project.parts.size() && i < project.scene->parts.size(); ++i) {
    const Bounds& bounds = project.scene->parts[i].bounds;
    if (project.parts[i].visible && !bounds.empty()) visit(bounds);
  }
}

}  // namespace

Bounds subject_bounds(const Project& project) {
  Bounds solid;
  for_each_visible(project, [&](const Bounds& part) {
    if (!is_flat(part)) solid.extend(part);
  });
  Bounds subject;
  for_each_visible(project, [&](const Bounds& part) {
    if (solid.empty() || !is_flat(part) || part.radius() <= kBackdrop * solid.radius()) subject.extend(part);
  });
  return subject.empty() ? project.scene->bounds : subject;
}

}  // namespace vamp::ui
