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

// Whether each part belongs to the subject.
std::vector<bool> subject_parts(const Project& project) {
  const size_t count = std::min(project.parts.size(), project.scene->parts.size());
  std::vector<bool> chosen(count);
  for (size_t i = 0; i < count; ++i) chosen[i] = project.parts[i].visible && !project.scene->parts[i].bounds.empty();
  const auto each = [&](auto visit) {
    for (size_t i = 0; i < count; ++i)
      if (chosen[i]) visit(i, project.scene->parts[i].bounds);
  };
  // A floor that bends up into a backdrop is not flat; but it is the one part far larger than the many others.
  Bounds largest;
  size_t visible = 0;
  each([&](size_t, const Bounds& part) {
    if (largest.empty() || part.radius() > largest.radius()) largest = part;
    ++visible;
  });
  const auto may_be_backdrop = [&](const Bounds& part) {
    return is_flat(part) || (part == largest && visible >= kMany);
  };
  Bounds solid;
  each([&](size_t, const Bounds& part) {
    if (!may_be_backdrop(part)) solid.extend(part);
  });
  if (solid.empty()) return chosen;
  each([&](size_t i, const Bounds& part) {
    if (may_be_backdrop(part) && part.radius() > kBackdrop * solid.radius()) chosen[i] = false;
  });
  return chosen;
}

// The corners of the triangles of the parts for which `wanted` holds.
template <class Wanted>
std::vector<vec3> corners_of(const Scene& scene, Wanted wanted) {
  std::vector<vec3> points;
  for (size_t i = 0; i < scene.triangles.size(); ++i) {
    if (!wanted(scene.triangle_part[i])) continue;
    for (int corner = 0; corner < 3; ++corner) points.push_back(scene.positions[scene.triangles[i][corner]]);
  }
  return points;
}

}  // namespace

Bounds subject_bounds(const Project& project) {
  const std::vector<bool> chosen = subject_parts(project);
  Bounds subject;
  for (size_t i = 0; i < chosen.size(); ++i)
    if (chosen[i]) subject.extend(project.scene->parts[i].bounds);
  return subject.empty() ? project.scene->bounds : subject;
}

std::vector<vec3> subject_points(const Project& project) {
  const std::vector<bool> chosen = subject_parts(project);
  std::vector<vec3> points =
      corners_of(*project.scene, [&](uint32_t part) { return part < chosen.size() && chosen[part]; });
  return points.empty() ? project.scene->positions : points;
}

std::vector<vec3> part_points(const Project& project, int part) {
  return corners_of(*project.scene, [part](uint32_t each) { return static_cast<int>(each) == part; });
}

}  // namespace vamp::ui
