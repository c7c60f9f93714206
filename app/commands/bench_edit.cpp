// `vamp bench edit`: what an edit costs.
#include <CLI/CLI.hpp>

#include "app/commands/bench.h"
#include "app/commands/option_values.h"
#include "bench/edit.h"
#include "bench/scene.h"
#include "engine/gpu/device.h"

namespace vamp {
namespace {

struct Options {
  std::string scene, rounds = "9", samples = "64";
};

Result<Report> run(const Options& options, const CommonOptions& common) {
  EditBench bench;
  VAMP_TRY(const uint32_t rounds, count_option(options.rounds, "--rounds", 1, 1000));
  VAMP_TRY(bench.samples, count_option(options.samples, "--samples", 1, 65536));
  VAMP_TRY(Project project, bench_project(options.scene));
  VAMP_TRY(const auto device, open_device(common));
  bench.scene_words = scene_words(options.scene, project);
  bench.rounds = static_cast<int>(rounds);
  return bench_edit(*device, std::move(project), bench);
}

}  // namespace

void add_bench_edit(CLI::App& bench, CommonOptions& common, Action& action) {
  auto options = std::make_shared<Options>();
  CLI::App* verb = add_benchmark(bench, "edit", "What an edit costs until the picture shows it", common, action,
                                 [options, &common] { return run(*options, common); });
  verb->add_option("scene", options->scene, "Model or project, or shapes[:TRIANGLES]; the shipped shoe if none");
  verb->add_option("--rounds", options->rounds, "How often each is measured")->type_name("N")->capture_default_str();
  verb->add_option("--samples", options->samples, "Of the picture that is edited")
      ->type_name("N")
      ->capture_default_str();
}

}  // namespace vamp
