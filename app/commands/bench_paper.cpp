// `vamp bench paper`: the measurements of Silva & Santos 2013 done again.
#include <CLI/CLI.hpp>

#include "app/commands/bench.h"
#include "app/commands/option_values.h"
#include "bench/paper.h"
#include "engine/gpu/device.h"

namespace vamp {
namespace {

struct Options {
  std::string rounds = "5", side = "512";
};

Result<Report> run(const Options& options, const CommonOptions& common) {
  VAMP_TRY(const uint32_t rounds, count_option(options.rounds, "--rounds", 1, 1000));
  VAMP_TRY(const uint32_t side, count_option(options.side, "--size", 64, 2048));
  VAMP_TRY(const auto device, open_device(common));
  return bench_paper(*device, {static_cast<int>(rounds), static_cast<int>(side)});
}

}  // namespace

void add_bench_paper(CLI::App& bench, CommonOptions& common, Action& action) {
  auto options = std::make_shared<Options>();
  CLI::App* verb = add_benchmark(bench, "paper", "The measurements of Silva & Santos 2013, theirs beside ours", common,
                                 action, [options, &common] { return run(*options, common); });
  verb->add_option("--rounds", options->rounds, "How often each is measured")->type_name("N")->capture_default_str();
  verb->add_option("--size", options->side, "Pixels a side")->type_name("N")->capture_default_str();
}

}  // namespace vamp
