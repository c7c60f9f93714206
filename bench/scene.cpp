#include "bench/scene.h"

#include <fmt/format.h>

#include <charconv>

#include "bench/shapes.h"
#include "engine/project/default_project.h"
#include "engine/project/project_file.h"

namespace vamp {
namespace {

std::shared_ptr<const Scene> without_part(const Scene& scene, int part) {
  auto rest = std::make_shared<Scene>(scene);
  rest->triangles.clear();
  rest->triangle_part.clear();
  for (size_t i = 0; i < scene.triangles.size(); ++i)
    if (static_cast<int>(scene.triangle_part[i]) != part) {
      rest->triangles.push_back(scene.triangles[i]);
      rest->triangle_part.push_back(scene.triangle_part[i]);
    }
  finish_scene(*rest);
  return rest;
}

Result<Project> open_any(const std::string& file) {
  constexpr std::string_view kShapes = "shapes";
  if (file.empty()) return default_project();
  if (!file.starts_with(kShapes) || (file.size() > kShapes.size() && file[kShapes.size()] != ':'))
    return open_scene(file);
  int triangles = 250000;
  if (file.size() > kShapes.size()) {
    const char* const end = file.data() + file.size();
    const auto [rest, error] = std::from_chars(file.data() + kShapes.size() + 1, end, triangles);
    if (error != std::errc() || rest != end || triangles < 500 || triangles > 10'000'000)
      return fail(ErrorKind::usage, "", "shapes:TRIANGLES", "500 to 10000000", "\"" + file + "\"");
  }
  return shapes_project(triangles);
}

}  // namespace

Result<Project> bench_project(const std::string& file, const std::string& without) {
  VAMP_TRY(Project project, open_any(file));
  if (!without.empty()) {
    const int part = project.scene->find_part(without);
    if (part < 0) return fail(ErrorKind::usage, "", "--without", "a part of the scene", "\"" + without + "\"");
    project.scene = without_part(*project.scene, part);
  }
  return project;
}

Status keep_one_light(Project& project) {
  if (project.lights.empty()) return fail(ErrorKind::bad_input, "", "lights", "at least one", "none");
  project.lights.resize(1);
  if (project.ambient == vec3(0)) project.ambient = vec3(0.2f);
  if (project.settings.ao_radius == 0) project.settings.ao_radius = project.scene->bounds.radius() * 0.2f;
  return {};
}

std::string scene_words(const std::string& file, const Project& project) {
  return fmt::format("{}, {} triangles", file.empty() ? "the shipped shoe" : file,
                     fmt::group_digits(project.scene->triangles.size()));
}

}  // namespace vamp
