#include "bench/moved.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>

#include "bench/series.h"
#include "engine/gpu/device.h"
#include "engine/render/renderer.h"

namespace vamp {
namespace {

constexpr int kWidth = 640, kHeight = 480;

struct Case {
  std::string words;
  std::vector<Placement> places;  // of all parts
};

// The shipped shoe's vamp and sole, or whatever stands first and last.
std::vector<Case> cases_of(const Project& project) {
  const Scene& scene = *project.scene;
  const std::vector<Placement> rest(project.parts.size());
  std::vector<Case> cases;
  const auto add = [&](size_t part, const std::string& how, const Placement& place) {
    std::vector<Placement> places = rest;
    places[part] = place;
    cases.push_back({fmt::format("{}, {}", scene.parts[part].name, how), places});
  };
  const int vamp = scene.find_part("Vamp"), sole = scene.find_part("Outsole");
  const size_t first = vamp < 0 ? 0 : static_cast<size_t>(vamp);
  const size_t second = sole < 0 ? project.parts.size() - 1 : static_cast<size_t>(sole);
  const float size = 2 * scene.parts[first].bounds.radius();
  for (const float share : {0.003f, 0.01f, 0.03f, 0.1f, 0.3f, 1.0f})
    add(first, fmt::format("moved by {:g} of its size", share), {vec3(0, share * size, 0), {}});
  add(first, "turned by 10 degrees", {{}, vec3(0, 0.1745f, 0)});
  add(second, "moved by 0.3 of its size", {vec3(0, -0.6f * scene.parts[second].bounds.radius(), 0), {}});
  // An exploded view: each part away from the middle of all.
  Case exploded{"all parts, exploded", rest};
  for (size_t i = 0; i < rest.size(); ++i) {
    const vec3 away = scene.parts[i].bounds.center() - scene.parts[first].bounds.center();
    if (scene.parts[i].bounds.radius() < 2 * size) exploded.places[i].offset = 0.5f * away;
  }
  cases.push_back(exploded);
  return cases;
}

Project with_places(Project project, const std::vector<Placement>& places) {
  for (size_t i = 0; i < places.size(); ++i) project.parts[i].place = places[i];
  return project;
}

// A renderer that keeps the refitted tree, or one with a tree of its own.
Result<std::unique_ptr<Renderer>> renderer_of(gpu::Device& device, const Project& project, bool remade) {
  auto renderer = std::make_unique<Renderer>(device);
  renderer->make_trees_later();
  TracePath path = renderer->key().path;
  path.ray_queries = false;
  renderer->set_trace_path(path);
  VAMP_TRY(const Change change, renderer->set_project(std::make_shared<const Project>(project)));
  static_cast<void>(change);
  if (remade) VAMP_CHECK_STATUS(renderer->make_tree());
  renderer->set_region(kWidth, kHeight, {0, 0, kWidth, kHeight});
  device.wait(renderer->preview(1));
  return renderer;
}

// Milliseconds of one processor.
double processor_ms(const Series& series) { return series.cpu() * processors(); }

}  // namespace

Status measure_moved_parts(gpu::Device& device, const Project& project, int rounds, Report& report) {
  report.table({"part", "boxes cost, of those at rest", "a sample, of a new tree's", "fitted, ms of a processor",
                "new tree, ms of a processor"});
  PlacedScene placed(project);
  const double rest = box_cost(placed.tables()->bvh);
  for (const Case& each : cases_of(project)) {
    const Project moved = with_places(project, each.places);
    VAMP_TRY(const auto refitted, renderer_of(device, moved, false));
    VAMP_TRY(const auto remade, renderer_of(device, moved, true));
    const double cost = box_cost(refitted->scene_tables()->bvh) / rest;
    Series in_refitted, in_remade, fit, make;
    for (int round = 0; round < rounds; ++round) {
      for (Renderer* const renderer : {refitted.get(), remade.get()}) {
        const Stopwatch watch;
        device.wait(renderer->preview(1));
        (renderer == refitted.get() ? in_refitted : in_remade).add(watch.stop());
      }
      placed.place(project);
      const Stopwatch fitting;
      placed.place(moved);
      fit.add(fitting.stop());
      const Stopwatch making;
      placed.make_tree();
      make.add(making.stop());
    }
    const double ratio = in_refitted.cpu() / in_remade.cpu();
    report.row({each.words, fmt::format("{:.3f}", cost), fmt::format("{:.3f}", ratio),
                fmt::format("{:.1f}", processor_ms(fit)), fmt::format("{:.0f}", processor_ms(make))});
    report.data()["moved"].push_back(Json{{"part", each.words},
                                          {"cost", cost},
                                          {"sample_ratio", ratio},
                                          {"refit_ms", processor_ms(fit)},
                                          {"new_tree_ms", processor_ms(make)}});
  }
  return {};
}

}  // namespace vamp
