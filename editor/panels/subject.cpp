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

// Of each part, where it stands.
std::vector<Bounds> bounds_of_parts(const Project& project) {
  std::vector<Bounds> bounds;
  for (size_t i = 0; i < project.parts.size(); ++i)
    bounds.push_back(motion_of(project, i).around(project.scene->parts[i].bounds));
  return bounds;
}

// Whether each part belongs to the subject.
std::vector<bool> subject_parts(const Project& project, const std::vector<Bounds>& bounds) {
  std::vector<bool> chosen(bounds.size());
  for (size_t i = 0; i < bounds.size(); ++i) chosen[i] = project.parts[i].visible && !bounds[i].empty();
  const auto each = [&](auto visit) {
    for (size_t i = 0; i < bounds.size(); ++i)
      if (chosen[i]) visit(i, bounds[i]);
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
std::vector<vec3> corners_of(const Project& project, Wanted wanted) {
  const Scene& scene = *project.scene;
  std::vector<vec3> points;
  for (size_t part = 0; part < scene.parts.size(); ++part) {
    if (!wanted(part)) continue;
    const RigidMotion motion = motion_of(project, part);
    const size_t first = scene.parts[part].first_triangle;
    for (size_t i = first; i < first + scene.parts[part].triangle_count; ++i)
      for (int corner = 0; corner < 3; ++corner)
        points.push_back(motion.point(scene.positions[scene.triangles[i][corner]]));
  }
  return points;
}

}  // namespace

Bounds subject_bounds(const Project& project) {
  const std::vector<Bounds> bounds = bounds_of_parts(project);
  const std::vector<bool> chosen = subject_parts(project, bounds);
  Bounds subject;
  for (size_t i = 0; i < chosen.size(); ++i)
    if (chosen[i]) subject.extend(bounds[i]);
  return subject.empty() ? project.scene->bounds : subject;
}

std::vector<vec3> subject_points(const Project& project) {
  const std::vector<bool> chosen = subject_parts(project, bounds_of_parts(project));
  std::vector<vec3> points = corners_of(project, [&](size_t part) { return chosen[part]; });
  return points.empty() ? project.scene->positions : points;
}

std::vector<vec3> part_points(const Project& project, int part) {
  return corners_of(project, [part](size_t each) { return static_cast<int>(each) == part; });
}

}  // namespace vamp::ui
