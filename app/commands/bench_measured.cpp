// `vamp bench measured`: what becomes of other laboratories' measurements.
#include <CLI/CLI.hpp>
#include <cstdlib>
#include <optional>

#include "app/commands/bench.h"
#include "app/commands/interrupt.h"
#include "bench/measured.h"
#include "engine/core/progress.h"

namespace vamp {
namespace {

Result<Report> run(const std::string& option) {
  const char* const variable = std::getenv("VAMP_TEST_DATA");
  const std::string data = !option.empty() ? option : variable != nullptr ? variable : "";
  if (data.empty()) return fail(ErrorKind::usage, "", "--data", "a folder of measurements (or VAMP_TEST_DATA)", "none");
  catch_interrupts();
  Progress progress;
  std::optional<Result<Report>> report;
  run_with_progress("Measured", progress, [&] { report = bench_measured(data, progress); });
  return std::move(*report);
}

}  // namespace

void add_bench_measured(CLI::App& bench, CommonOptions& common, Action& action) {
  auto data = std::make_shared<std::string>();
  CLI::App* verb = add_benchmark(bench, "measured", "How far fits are from real measurements", common, action,
                                 [data] { return run(*data); });
  verb->add_option("--data", *data, "Folder of measurements; by default that of VAMP_TEST_DATA")->type_name("FOLDER");
}

}  // namespace vamp
