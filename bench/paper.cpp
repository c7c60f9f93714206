// Figures 6 and 7: what lights, triangles, materials and ambient occlusion cost.
#include "bench/paper.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "bench/embree_scene.h"
#include "bench/material.h"
#include "bench/progressive.h"
#include "bench/sample_cost.h"
#include "bench/scene.h"
#include "bench/shapes.h"
#include "engine/gpu/device.h"
#include "engine/image/compare.h"

namespace vamp {
namespace {

const BenchMaterial kFour{.used = {Model::lambert, Model::blinn_phong, Model::ward, Model::cook_torrance}};

// Point lights on a circle, all together as bright as one.
Project with_point_lights(Project project, int count) {
  const vec3 centre = project.lights[0].center, middle = project.camera.target;
  const vec3 arm = centre - middle;
  const Light like = project.lights[0];
  project.lights.clear();
  for (int i = 0; i < count; ++i) {
    const float angle = 2 * std::numbers::pi_v<float> * static_cast<float>(i) / static_cast<float>(count);
    Light light = like;
    light.type = LightType::point;
    light.power = like.power / static_cast<float>(count);
    light.center = middle + vec3(arm.x * std::cos(angle) - arm.z * std::sin(angle), arm.y,
                                 arm.x * std::sin(angle) + arm.z * std::cos(angle));
    project.lights.push_back(light);
  }
  return project;
}

// Share of the pixels that show one of the first `parts` parts.
double share_of_parts(const Project& project, size_t parts) {
  constexpr int kSide = 256;
  const EmbreeScene embree(project.scene->positions, project.scene->triangles, EmbreeScene::Edges::fast);
  const CameraFrame camera = camera_frame(project.camera, 1);
  int seen = 0;
  for (int i = 0; i < kSide * kSide; ++i) {
    const vec2 at((static_cast<float>(i % kSide) + 0.5f) / kSide, (static_cast<float>(i / kSide) + 0.5f) / kSide);
    const int triangle = embree.nearest(camera.origin, camera_ray(camera, 2 * at.x - 1, 1 - 2 * at.y)).triangle;
    seen += triangle >= 0 && project.scene->triangle_part[static_cast<size_t>(triangle)] < parts;
  }
  return static_cast<double>(seen) / (kSide * kSide);
}

// A scene at several sizes of one thing.
struct Step {
  std::string name;
  Project project;
  std::string paper;  // what it says of the like
};

Status measure(gpu::Device& device, const PaperBench& options, const std::string& what, std::vector<Step> steps,
               Report& report) {
  std::vector<std::unique_ptr<SampleCost>> costs;
  for (Step& step : steps) {
    VAMP_TRY(auto cost,
             SampleCost::make(device, std::move(step.project), options.side, options.side, SampleCost::Rounds::single));
    costs.push_back(std::move(cost));
  }
  for (int round = 0; round < options.rounds; ++round)
    for (const auto& cost : costs) VAMP_CHECK_STATUS(cost->single_round());
  for (size_t i = 0; i < steps.size(); ++i) {
    const Series& time = costs[i]->single;
    report.row({what + ": " + steps[i].name,
                fmt::format("{:.1f} ({:.1f} to {:.1f})", time.cpu(), time.cpu(0.1), time.cpu(0.9)),
                fmt::format("{:.2f}", time.cpu() / costs[0]->single.cpu()), steps[i].paper});
    report.data()[what].push_back({{"step", steps[i].name}, {"sample", time.json()}});
  }
  return {};
}

}  // namespace

Status paper_figure6(gpu::Device& device, const PaperBench& options, Report& report) {
  report.table({"figure 6", "a sample, ms", "of the first", "paper"});
  const Project shapes = shapes_project(250'000);
  std::vector<Step> steps;
  for (const int lights : {1, 2, 4, 8})
    steps.push_back({std::to_string(lights), with_point_lights(shapes, lights),
                     lights == 1 ? "18.0 ms" : "in proportion to the lights"});
  VAMP_CHECK_STATUS(measure(device, options, "a: point lights", std::move(steps), report));

  steps.clear();
  for (const int thousands : {250, 500, 750, 1000})
    steps.push_back({fmt::format("{}", fmt::group_digits(1000 * thousands)), shapes_project(1000 * thousands),
                     thousands == 250 ? "18.0 ms" : "in proportion, more near a million"});
  VAMP_CHECK_STATUS(measure(device, options, "b: triangles", std::move(steps), report));

  steps.clear();
  for (const int materials : {1, 2, 4, 8}) {
    steps.push_back({std::to_string(materials), shapes, materials == 1 ? "" : "less than in proportion"});
    dress(steps.back().project, kFour, materials);
  }
  VAMP_CHECK_STATUS(measure(device, options, "c: materials in view", std::move(steps), report));

  steps.clear();
  for (const size_t parts : {0u, 2u, 4u, 6u, 8u}) {
    const double share = share_of_parts(shapes, parts);
    steps.push_back({fmt::format("{:.0f} %", 100 * share), shapes, parts == 4 ? "58 %: 36 frames a second" : ""});
    Project& project = steps.back().project;
    MaterialInstance lambert = project.materials[0];
    lambert.fit = bench_material({.used = {Model::lambert}, .functions = 1, .residual = false});
    project.materials.push_back(lambert);
    for (size_t i = parts; i < project.parts.size(); ++i) project.parts[i].material = 1;
    if (parts == 0) project.materials[0] = lambert;
  }
  return measure(device, options, "d: pixels of such a material", std::move(steps), report);
}

Status paper_figure7(gpu::Device& device, const PaperBench& options, Report& report) {
  constexpr uint32_t kConverged = 1024, kSeed = 1;
  constexpr int kSide = 256;
  VAMP_TRY(Project shoe, bench_project(""));
  VAMP_CHECK_STATUS(keep_one_light(shoe));
  Project dark = shoe;
  dark.ambient = vec3(0);
  report.table({"figure 7: the shoe", "a sample, ms", "of the first", "paper"});
  VAMP_CHECK_STATUS(measure(device, options, "ambient occlusion",
                            {{"without", std::move(dark), "62 frames a second"}, {"with", shoe, "45: 1.38"}}, report));

  VAMP_TRY(const auto picture, Progressive::make(device, shoe, {.side = kSide}));
  VAMP_TRY(const Image converged, picture->picture(kSeed + 1, kConverged));
  VAMP_TRY(const ErrorCurve curve, picture->run(kSeed, 64, converged));
  report.table({fmt::format("figure 7: converging, {0} x {0}", kSide), "ms", "MSSIM", "relMSE"});
  for (const ErrorPoint& p : curve) {
    report.row({fmt::format("{} samples", p.samples), fmt::format("{:.0f}", p.ms), fmt::format("{:.3f}", p.mssim),
                fmt::format("{:.1e}", p.rel_mse)});
    report.data()["converging"].push_back(
        {{"samples", p.samples}, {"ms", p.ms}, {"mssim", p.mssim}, {"rel_mse", p.rel_mse}});
  }
  report.remark("The paper finds noise imperceptible after about 20 frames, half a second there.");
  return {};
}

Result<Report> bench_paper(gpu::Device& device, const PaperBench& options) {
  Report report("paper", fmt::format("Shapes unless said, {0} x {0}, one rectangle light and ambient, a primary ray a "
                                     "sample; medians of {1} alternating rounds, {2}.",
                                     options.side, options.rounds, device.info().name));
  VAMP_CHECK_STATUS(paper_table3(device, options, report));
  VAMP_CHECK_STATUS(paper_table4(device, options, report));
  VAMP_CHECK_STATUS(paper_figure6(device, options, report));
  VAMP_CHECK_STATUS(paper_figure7(device, options, report));
  return report;
}

}  // namespace vamp
