// `vamp bench fit`: how good fits are, with curves of error against bytes and time.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cstdio>
#include <optional>

#include "app/commands/bench.h"
#include "app/commands/interrupt.h"
#include "app/commands/option_values.h"
#include "bench/fit.h"
#include "engine/core/files.h"

namespace vamp {
namespace {

struct Options {
  bool quick = false;
  std::string cache = "build/bench-fit", size = "64", samples = "25", threads = "0", materials, page;
};

Status run(const Options& options, const CommonOptions& common) {
  FitBench bench;
  VAMP_TRY(const uint32_t size, count_option(options.size, "--size", 24, 256));
  VAMP_TRY(const uint32_t samples, count_option(options.samples, "--spp", 2, 4096));
  VAMP_TRY(const uint32_t threads, count_option(options.threads, "--threads", 0, 256));
  bench.data = {options.cache, static_cast<int>(size), static_cast<int>(samples), !options.quick};
  for (const std::string_view name : list_option(options.materials)) bench.materials.emplace_back(name);
  bench.threads = static_cast<int>(threads);
  catch_interrupts();
  Progress progress;
  std::optional<Result<FitCurves>> found;
  run_with_progress("Fits", progress, [&] { found = bench_fit(bench, progress); });
  if (!*found) return tl::unexpected(found->error());
  FitCurves& curves = **found;
  if (!options.page.empty()) {
    // The plots of fitting.md lie in fitting/ beside it.
    const fs::path folder = fs::path(options.page).replace_extension();
    std::error_code failure;
    fs::create_directories(folder, failure);
    Report page = curves.report;
    for (const auto& [name, figure] : {std::pair("bytes", &curves.by_bytes), {"time", &curves.by_time}}) {
      VAMP_CHECK_STATUS(write_text_atomically(folder / fmt::format("{}.svg", name), figure->svg()));
      page.remark(fmt::format("![error by {0}]({1}/{0}.svg)", name, folder.filename().string()));
    }
    VAMP_CHECK_STATUS(page.write_into(options.page));
  }
  std::fputs((common.json ? print_json(curves.report.json()) : curves.report.text()).c_str(), stdout);
  return {};
}

}  // namespace

void add_bench_fit(CLI::App& bench, CommonOptions& common, Action& action) {
  auto options = std::make_shared<Options>();
  CLI::App* verb = bench.add_subcommand("fit", "How far fits are from measurements, against bytes and time");
  verb->add_option("--cache", options->cache, "Folder of measurements and figures that are kept: 1.3 GiB")
      ->type_name("FOLDER")
      ->capture_default_str();
  verb->add_option("--materials", options->materials, "Some of them; all six by default")->type_name("NAME,NAME");
  verb->add_option("--size", options->size, "Texels across each material")->type_name("N")->capture_default_str();
  verb->add_option("--spp", options->samples, "Paths for each texel and view")->type_name("S")->capture_default_str();
  verb->add_flag(
      "--quick", options->quick,
      "Without the fits of few and of many functions and those without a ring; those that are kept are shown");
  verb->add_option("--threads", options->threads, "0: one for each core")->capture_default_str();
  verb->add_option("--into", options->page, "Also put the figures into this page, in place of its block of this name")
      ->type_name("FILE.md");
  verb->add_flag("--json", common.json, "Print the figures as JSON");
  verb->callback([options, &common, &action] { action = [options, &common] { return run(*options, common); }; });
}

}  // namespace vamp
