// `vamp bench peers`: a sample beside those of other path tracers.
#include <CLI/CLI.hpp>

#include "app/commands/bench.h"
#include "app/commands/option_values.h"
#include "bench/peers.h"
#include "bench/scene.h"
#include "engine/gpu/device.h"

namespace vamp {
namespace {

struct Options {
  std::string scene, without, rounds = "5", side = "512";
};

Result<Report> run(const Options& options, const CommonOptions& common) {
  PeersBench bench;
  VAMP_TRY(const uint32_t rounds, count_option(options.rounds, "--rounds", 1, 1000));
  VAMP_TRY(const uint32_t side, count_option(options.side, "--size", 64, 4096));
  VAMP_TRY(Project project, bench_project(options.scene, options.without));
  VAMP_TRY(const auto device, open_device(common));
  if (!options.scene.empty()) bench.name += " " + options.scene;
  bench.scene_words = scene_words(options.scene, project);
  bench.rounds = static_cast<int>(rounds);
  bench.side = static_cast<int>(side);
  return bench_peers(*device, std::move(project), bench);
}

}  // namespace

void add_bench_peers(CLI::App& bench, CommonOptions& common, Action& action) {
  auto options = std::make_shared<Options>();
  CLI::App* verb = add_benchmark(bench, "peers", "A sample beside those of Embree's path tracer and of Cycles", common,
                                 action, [options, &common] { return run(*options, common); });
  verb->add_option("scene", options->scene, "Model or project, or shapes[:TRIANGLES]; the shipped shoe if none");
  verb->add_option("--without", options->without, "Leave out a part")->type_name("PART");
  verb->add_option("--rounds", options->rounds, "How often each is measured")->type_name("N")->capture_default_str();
  verb->add_option("--size", options->side, "Pixels a side")->type_name("N")->capture_default_str();
}

}  // namespace vamp
