// `vamp bench kernels`: how long the picture waits for kernels.
#include <CLI/CLI.hpp>

#include "app/commands/bench.h"
#include "app/commands/option_values.h"
#include "bench/kernels.h"
#include "bench/scene.h"
#include "engine/core/files.h"

namespace vamp {
namespace {

struct Options {
  std::string rounds = "3", seconds = "3";
};

Result<Report> run(const Options& options, const CommonOptions& common) {
  KernelsBench bench;
  VAMP_TRY(const uint32_t rounds, count_option(options.rounds, "--rounds", 1, 1000));
  VAMP_TRY(const uint32_t seconds, count_option(options.seconds, "--seconds", 1, 1000));
  VAMP_TRY(const Project dressed, bench_project(""));
  VAMP_TRY(Project plain, bench_project((shipped_dir("scenes") / "derby.glb").string()));
  // The same lights and camera, and the model's own materials.
  plain.scene = dressed.scene;
  plain.lights = dressed.lights;
  plain.camera = dressed.camera;
  plain.ambient = dressed.ambient;
  plain.settings = dressed.settings;
  plain.environment = dressed.environment;
  bench.scene_words = scene_words("", dressed);
  bench.rounds = static_cast<int>(rounds);
  bench.seconds = seconds;
  return bench_kernels({.device = common.device, .validate = common.validate}, plain, dressed, bench);
}

}  // namespace

void add_bench_kernels(CLI::App& bench, CommonOptions& common, Action& action) {
  auto options = std::make_shared<Options>();
  CLI::App* verb = add_benchmark(bench, "kernels", "How long the picture waits for kernels that are not there yet",
                                 common, action, [options, &common] { return run(*options, common); });
  verb->add_option("--rounds", options->rounds, "How often each case is measured")
      ->type_name("N")
      ->capture_default_str();
  verb->add_option("--seconds", options->seconds, "That are watched after each event")
      ->type_name("N")
      ->capture_default_str();
}

}  // namespace vamp
