// `vamp bench accuracy`: the page of errors against costs, with its plots.
#include <CLI/CLI.hpp>
#include <cstdio>

#include "app/commands/bench.h"
#include "bench/accuracy.h"
#include "engine/core/json.h"
#include "engine/gpu/device.h"

namespace vamp {
namespace {

struct Options {
  std::string page = "docs/accuracy.md";
  bool quick = false;
};

Status run(const Options& options, bool written, const CommonOptions& common) {
  AccuracyBench bench;
  if (options.quick) bench = {.lobes = 50, .pairs = 200, .rounds = 2, .side = 96, .samples = 16};
  VAMP_TRY(const auto device, open_device(common));
  VAMP_TRY(const Accuracy found, bench_accuracy(*device, bench));
  if (written) VAMP_CHECK_STATUS(write_page(found.report, found.plots, options.page));
  std::fputs((common.json ? print_json(found.report.json()) : found.report.text()).c_str(), stdout);
  return {};
}

}  // namespace

void add_bench_accuracy(CLI::App& bench, CommonOptions& common, Action& action) {
  auto options = std::make_shared<Options>();
  CLI::App* verb =
      bench.add_subcommand("accuracy", "Errors against costs: models, weights, residual, taps, directions");
  CLI::Option* page = verb->add_option("--into", options->page, "The page whose block of this name is replaced")
                          ->type_name("FILE.md")
                          ->capture_default_str();
  verb->add_flag("--quick", options->quick,
                 "Few questions and small pictures, for a trial; writes a page only if named");
  verb->add_flag("--json", common.json, "Print the figures as JSON");
  verb->callback([options, page, &common, &action] {
    action = [options, page, &common] { return run(*options, !options->quick || page->count() > 0, common); };
  });
}

}  // namespace vamp
