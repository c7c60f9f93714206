// `vamp bench mixture`: whether directions drawn from materials help.
#include <CLI/CLI.hpp>

#include "app/commands/bench.h"
#include "app/commands/option_values.h"
#include "bench/mixture.h"

namespace vamp {
namespace {

struct Options {
  std::string side = "24", rays = "2048";
};

Result<Report> run(const Options& options) {
  MixtureBench bench;
  VAMP_TRY(const uint32_t side, count_option(options.side, "--side", 1, 1000));
  VAMP_TRY(bench.rays, count_option(options.rays, "--rays", 2, 1 << 24));
  bench.side = static_cast<int>(side);
  return bench_mixture(bench);
}

}  // namespace

void add_bench_mixture(CLI::App& bench, CommonOptions& common, Action& action) {
  auto options = std::make_shared<Options>();
  CLI::App* verb = add_benchmark(bench, "mixture", "Directions drawn from a material beside points drawn on lights",
                                 common, action, [options] { return run(*options); });
  verb->add_option("--side", options->side, "Texels and viewers a side")->type_name("N")->capture_default_str();
  verb->add_option("--rays", options->rays, "Rays of each estimate")->type_name("N")->capture_default_str();
}

}  // namespace vamp
