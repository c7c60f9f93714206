// `vamp bench lights`: what many lights cost.
#include <CLI/CLI.hpp>

#include "app/commands/bench.h"
#include "app/commands/option_values.h"
#include "bench/lights.h"
#include "bench/scene.h"
#include "engine/gpu/device.h"

namespace vamp {
namespace {

struct Options {
  std::string scene, rounds = "5", side = "192", samples = "32", reference = "2048", slots;
};

Result<Report> run(const Options& options, const CommonOptions& common) {
  LightsBench bench;
  VAMP_TRY(const uint32_t rounds, count_option(options.rounds, "--rounds", 1, 1000));
  VAMP_TRY(const uint32_t side, count_option(options.side, "--size", 16, 1024));
  VAMP_TRY(bench.samples, count_option(options.samples, "--samples", 8, 4096));
  VAMP_TRY(bench.reference, count_option(options.reference, "--reference", 64, 1 << 20));
  if (!options.slots.empty()) {
    VAMP_TRY(bench.draws.slots, count_option(options.slots, "--slots", 1, 8));
  }
  VAMP_TRY(Project project, bench_project(options.scene));
  VAMP_TRY(const auto device, open_device(common));
  if (!options.scene.empty()) bench.name += " " + options.scene;
  bench.scene_words = scene_words(options.scene, project);
  bench.rounds = static_cast<int>(rounds);
  bench.side = static_cast<int>(side);
  return bench_lights(*device, std::move(project), bench);
}

}  // namespace

void add_bench_lights(CLI::App& bench, CommonOptions& common, Action& action) {
  auto options = std::make_shared<Options>();
  CLI::App* verb = add_benchmark(bench, "lights", "What many lights cost, beside one and beside a ray to each of them",
                                 common, action, [options, &common] { return run(*options, common); });
  verb->add_option("scene", options->scene, "Model or project, or shapes[:TRIANGLES]; the shipped shoe if none");
  verb->add_option("--rounds", options->rounds, "How often each is timed")->type_name("N")->capture_default_str();
  verb->add_option("--size", options->side, "Pixels a side")->type_name("N")->capture_default_str();
  verb->add_option("--samples", options->samples, "At which errors are compared")
      ->type_name("N")
      ->capture_default_str();
  verb->add_option("--reference", options->reference, "Samples of the references")
      ->type_name("N")
      ->capture_default_str();
  verb->add_option("--slots", options->slots, "Lights that a sample draws; as the program does unless said")
      ->type_name("N");
}

}  // namespace vamp
