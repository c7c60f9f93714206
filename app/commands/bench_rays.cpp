// `vamp bench rays` and `vamp bench triangles`: rays beside Embree's, and what more triangles cost.
#include <CLI/CLI.hpp>

#include "app/commands/bench.h"
#include "app/commands/option_values.h"
#include "bench/rays.h"
#include "bench/scene.h"
#include "engine/gpu/device.h"

namespace vamp {
namespace {

struct Options {
  std::string scene, without, rounds, side = "512";
};

// Rays go through whole tiles.
Result<int> side_of(const Options& options) {
  VAMP_TRY(const uint32_t side, count_option(options.side, "--size", 64, 4096));
  if (side % 64 == 0) return static_cast<int>(side);
  return fail(ErrorKind::usage, "", "--size", "a multiple of 64", options.side);
}

Result<Report> run_rays(const Options& options, const CommonOptions& common) {
  RaysBench bench;
  VAMP_TRY(const uint32_t rounds, count_option(options.rounds, "--rounds", 1, 1000));
  VAMP_TRY(bench.side, side_of(options));
  VAMP_TRY(Project project, bench_project(options.scene, options.without));
  VAMP_TRY(const auto device, open_device(common));
  if (!options.scene.empty()) bench.name += " " + options.scene;
  if (device->info().ray_queries) bench.name += " with ray queries";
  bench.scene_words = scene_words(options.scene, project);
  bench.rounds = static_cast<int>(rounds);
  return bench_rays(*device, std::move(project), bench);
}

Result<Report> run_triangles(const Options& options, const CommonOptions& common) {
  TrianglesBench bench;
  VAMP_TRY(const uint32_t rounds, count_option(options.rounds, "--rounds", 1, 1000));
  VAMP_TRY(bench.side, side_of(options));
  VAMP_TRY(const auto device, open_device(common));
  bench.rounds = static_cast<int>(rounds);
  return bench_triangles(*device, bench);
}

void add_options(CLI::App* verb, Options& options) {
  verb->add_option("--rounds", options.rounds, "How often each is measured")->type_name("N")->capture_default_str();
  verb->add_option("--size", options.side, "Pixels a side")->type_name("N")->capture_default_str();
}

}  // namespace

void add_bench_rays(CLI::App& bench, CommonOptions& common, Action& action) {
  auto options = std::make_shared<Options>(Options{.rounds = "15"});
  CLI::App* verb = add_benchmark(bench, "rays", "How fast rays are, in units of Embree's speed on the same ones",
                                 common, action, [options, &common] { return run_rays(*options, common); });
  verb->add_option("scene", options->scene, "Model or project, or shapes[:TRIANGLES]; the shipped shoe if none");
  verb->add_option("--without", options->without, "Leave out a part")->type_name("PART");
  add_options(verb, *options);
}

void add_bench_triangles(CLI::App& bench, CommonOptions& common, Action& action) {
  auto options = std::make_shared<Options>(Options{.rounds = "9"});
  add_options(add_benchmark(bench, "triangles", "What rays and a sample cost with more and more triangles", common,
                            action, [options, &common] { return run_triangles(*options, common); }),
              *options);
}

}  // namespace vamp
