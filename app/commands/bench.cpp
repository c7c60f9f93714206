#include "app/commands/bench.h"

#include <CLI/CLI.hpp>
#include <cstdio>

#include "engine/core/json.h"

namespace vamp {

CLI::App* add_benchmark(CLI::App& bench, const char* name, const char* what, CommonOptions& common, Action& action,
                        std::function<Result<Report>()> run) {
  CLI::App* verb = bench.add_subcommand(name, what);
  auto page = std::make_shared<std::string>();
  verb->add_option("--into", *page, "Also put the figures into this page, in place of its block of this name")
      ->type_name("FILE.md");
  verb->add_flag("--json", common.json, "Print the figures as JSON");
  verb->callback([page, run = std::move(run), &common, &action] {
    action = [page, run, &common]() -> Status {
      VAMP_TRY(const Report report, run());
      if (!page->empty()) VAMP_CHECK_STATUS(report.write_into(*page));
      std::fputs((common.json ? print_json(report.json()) : report.text()).c_str(), stdout);
      return {};
    };
  });
  return verb;
}

void add_bench(CLI::App& app, CommonOptions& common, Action& action) {
  CLI::App* verb = app.add_subcommand("bench", "Measure how fast and how exact the program is, beside its peers");
  verb->require_subcommand(1);
  add_bench_accuracy(*verb, common, action);
  add_bench_edit(*verb, common, action);
  add_bench_edits(*verb, common, action);
  add_bench_fit(*verb, common, action);
  add_bench_frame(*verb, common, action);
  add_bench_kernels(*verb, common, action);
  add_bench_lights(*verb, common, action);
  add_bench_materials(*verb, common, action);
  add_bench_measured(*verb, common, action);
  add_bench_mixture(*verb, common, action);
  add_bench_noise(*verb, common, action);
  add_bench_paper(*verb, common, action);
  add_bench_peers(*verb, common, action);
  add_bench_rays(*verb, common, action);
  add_bench_shading(*verb, common, action);
  add_bench_speed_error(*verb, common, action);
  add_bench_triangles(*verb, common, action);
  add_bench_window(*verb, common, action);
}

}  // namespace vamp
