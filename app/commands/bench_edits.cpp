// `vamp bench edits`: whether edits tell the truth.
#include <CLI/CLI.hpp>
#include <optional>

#include "app/commands/bench.h"
#include "app/commands/interrupt.h"
#include "app/commands/option_values.h"
#include "bench/edits.h"
#include "engine/core/progress.h"

namespace vamp {
namespace {

struct Options {
  std::string size = "64", samples = "16", clusters = "32", cache;
};

Result<Report> run(const Options& options) {
  EditsBench bench;
  VAMP_TRY(const uint32_t size, count_option(options.size, "--size", 8, 256));
  VAMP_TRY(const uint32_t samples, count_option(options.samples, "--spp", 1, 65536));
  VAMP_TRY(const uint32_t clusters, count_option(options.clusters, "--clusters", 1, 256));
  bench.size = static_cast<int>(size);
  bench.samples = static_cast<int>(samples);
  bench.clusters = static_cast<int>(clusters);
  bench.cache = options.cache;
  catch_interrupts();
  Progress progress;
  std::optional<Result<Report>> report;
  run_with_progress("Edits", progress, [&] { report = bench_edits(bench, progress); });
  return std::move(*report);
}

}  // namespace

void add_bench_edits(CLI::App& bench, CommonOptions& common, Action& action) {
  auto options = std::make_shared<Options>();
  CLI::App* verb = add_benchmark(bench, "edits", "How far an edited fit is from the material really changed", common,
                                 action, [options] { return run(*options); });
  verb->add_option("--size", options->size, "Texels across")->type_name("N")->capture_default_str();
  verb->add_option("--spp", options->samples, "Paths for each texel and view")->type_name("S")->capture_default_str();
  verb->add_option("--clusters", options->clusters, "Of the fits")->type_name("N")->capture_default_str();
  verb->add_option("--cache", options->cache, "Where acquisitions are kept for the next time")->type_name("FOLDER");
}

}  // namespace vamp
