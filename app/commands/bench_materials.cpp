// `vamp bench materials`: what more materials in view cost.
#include <CLI/CLI.hpp>

#include "app/commands/bench.h"
#include "app/commands/option_values.h"
#include "bench/materials.h"
#include "bench/scene.h"
#include "engine/gpu/device.h"

namespace vamp {
namespace {

struct Options {
  std::string scene = "shapes", rounds = "15", side = "512";
};

Result<Report> run(const Options& options, const CommonOptions& common) {
  MaterialsBench bench;
  VAMP_TRY(const uint32_t rounds, count_option(options.rounds, "--rounds", 1, 1000));
  VAMP_TRY(const uint32_t side, count_option(options.side, "--size", 64, 4096));
  VAMP_TRY(Project project, bench_project(options.scene));
  VAMP_TRY(const auto device, open_device(common));
  if (options.scene != Options().scene) bench.name += " " + options.scene;
  bench.scene_words = scene_words(options.scene, project);
  bench.rounds = static_cast<int>(rounds);
  bench.side = static_cast<int>(side);
  return bench_materials(*device, std::move(project), bench);
}

}  // namespace

void add_bench_materials(CLI::App& bench, CommonOptions& common, Action& action) {
  auto options = std::make_shared<Options>();
  CLI::App* verb = add_benchmark(bench, "materials", "What a sample costs with 1 to 8 materials in view", common,
                                 action, [options, &common] { return run(*options, common); });
  verb->add_option("scene", options->scene, "Model or project of eight parts, or shapes[:TRIANGLES]")
      ->capture_default_str();
  verb->add_option("--rounds", options->rounds, "How often each is measured")->type_name("N")->capture_default_str();
  verb->add_option("--size", options->side, "Pixels a side")->type_name("N")->capture_default_str();
}

}  // namespace vamp
