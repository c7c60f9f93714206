// `vamp bench window`: from the mouse to the screen.
#include <CLI/CLI.hpp>
#include <algorithm>

#include "app/commands/bench.h"
#include "app/commands/option_values.h"
#include "bench/scene.h"
#include "bench/window.h"

namespace vamp {
namespace {

struct Options {
  std::string rounds = "30", samples = "64";
  std::vector<std::string> only;
};

Result<Report> run(const Options& options) {
  WindowBench bench;
  VAMP_TRY(const uint32_t rounds, count_option(options.rounds, "--rounds", 1, 1000));
  VAMP_TRY(bench.samples, count_option(options.samples, "--samples", 1, 65536));
  VAMP_TRY(Project project, bench_project(""));
  bench.scene_words = scene_words("", project);
  bench.rounds = static_cast<int>(rounds);
  const auto wanted = [&](const char* part) {
    return options.only.empty() || std::find(options.only.begin(), options.only.end(), part) != options.only.end();
  };
  bench.edits = wanted("edits");
  bench.view = wanted("view");
  bench.pace = wanted("pace");
  bench.cycles = wanted("cycles");
  return bench_window(std::move(project), bench);
}

}  // namespace

void add_bench_window(CLI::App& bench, CommonOptions& common, Action& action) {
  auto options = std::make_shared<Options>();
  CLI::App* verb =
      add_benchmark(bench, "window", "From the mouse to changed pixels in the editor's window, beside Cycles' viewport",
                    common, action, [options] { return run(*options); });
  verb->add_option("--rounds", options->rounds, "How often each is measured")->type_name("N")->capture_default_str();
  verb->add_option("--samples", options->samples, "Of the picture that is edited")
      ->type_name("N")
      ->capture_default_str();
  verb->add_option("--only", options->only,
                   "Parts: edits, view, pace (busy and resting window), cycles; all by default")
      ->delimiter(',')
      ->check(CLI::IsMember({"edits", "view", "pace", "cycles"}));
}

}  // namespace vamp
