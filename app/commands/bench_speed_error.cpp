// `vamp bench speed-error`: error against time for each short cut.
#include <CLI/CLI.hpp>
#include <cstdio>

#include "app/commands/bench.h"
#include "app/commands/option_values.h"
#include "bench/scene.h"
#include "bench/speed_error.h"
#include "engine/core/json.h"
#include "engine/gpu/device.h"

namespace vamp {
namespace {

struct Options {
  std::string scene, cache = "build/bench-speed-error", reference = "16384", rounds = "3", side = "128", page;
};

Status run(const Options& options, const CommonOptions& common) {
  SpeedErrorBench bench;
  VAMP_TRY(bench.reference_samples, count_option(options.reference, "--reference", 64, 1 << 20));
  VAMP_TRY(const uint32_t rounds, count_option(options.rounds, "--rounds", 1, 1000));
  VAMP_TRY(const uint32_t side, count_option(options.side, "--size", 64, 1024));
  VAMP_TRY(const Project project, bench_project(options.scene));
  VAMP_TRY(const auto device, open_device(common));
  if (!options.scene.empty()) bench.name += "-" + options.scene;
  bench.scene_words = scene_words(options.scene, project);
  bench.cache = options.cache;
  bench.rounds = static_cast<int>(rounds);
  bench.side = static_cast<int>(side);
  VAMP_TRY(const SpeedError found, bench_speed_error(*device, project, bench));
  if (!options.page.empty()) VAMP_CHECK_STATUS(write_page(found.report, found.plots, options.page));
  std::fputs((common.json ? print_json(found.report.json()) : found.report.text()).c_str(), stdout);
  return {};
}

}  // namespace

void add_bench_speed_error(CLI::App& bench, CommonOptions& common, Action& action) {
  auto options = std::make_shared<Options>();
  CLI::App* verb = bench.add_subcommand("speed-error", "Error against time, for samples and for each short cut");
  verb->add_option("scene", options->scene, "Model or project, or shapes; the shipped shoe if none");
  verb->add_option("--cache", options->cache, "Folder in which reference pictures are kept")
      ->type_name("FOLDER")
      ->capture_default_str();
  verb->add_option("--reference", options->reference, "Samples of the reference picture")
      ->type_name("N")
      ->capture_default_str();
  verb->add_option("--rounds", options->rounds, "Pictures of which the errors are a mean")
      ->type_name("N")
      ->capture_default_str();
  verb->add_option("--size", options->side, "Pixels a side")->type_name("N")->capture_default_str();
  verb->add_option("--into", options->page, "Also put the figures into this page, and plots beside it")
      ->type_name("FILE.md");
  verb->add_flag("--json", common.json, "Print the figures as JSON");
  verb->callback([options, &common, &action] { action = [options, &common] { return run(*options, common); }; });
}

}  // namespace vamp
