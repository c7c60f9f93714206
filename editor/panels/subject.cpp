#include "editor/panels/subject.h"

#include <algorithm>

namespace vamp::ui {

namespace {

constexpr float kBackdrop = 3;
constexpr float kFlat = 0.02f;  // least over largest extent
constexpr size_t kMany = 4;

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
  // A floor that bends up into a backdrop is not flat; but it is the one part far larger than the many others.
  Bounds largest;
  size_t count = 0;
  for_each_visible(project, [&](const Bounds& part) {
    if (largest.empty() || part.radius() > largest.radius()) largest = part;
    ++count;
  });
  const auto may_be_backdrop = [&](const Bounds& part) { return is_flat(part) || (part == largest && count >= kMany); };
  Bounds solid;
  for_each_visible(project, [&](const Bounds& part) {
    if (!may_be_backdrop(part)) solid.extend(part);
  });
  Bounds subject;
  for_each_visible(project, [&](const Bounds& part) {
    const bool backdrop = !solid.empty() && may_be_backdrop(part) && part.radius() > kBackdrop * solid.radius();
    if (!backdrop) subject.extend(part);
  });
  return subject.empty() ? project.scene->bounds : subject;
}

}  // namespace vamp::ui
