#pragma once
// `vamp bench`: how fast and how exact the program is, beside its peers. What its verbs share.
#include <functional>

#include "app/commands/command.h"
#include "bench/report.h"

namespace vamp {

void add_bench_accuracy(CLI::App& bench, CommonOptions& common, Action& action);
void add_bench_edit(CLI::App& bench, CommonOptions& common, Action& action);
void add_bench_edits(CLI::App& bench, CommonOptions& common, Action& action);
void add_bench_fit(CLI::App& bench, CommonOptions& common, Action& action);
void add_bench_frame(CLI::App& bench, CommonOptions& common, Action& action);
void add_bench_kernels(CLI::App& bench, CommonOptions& common, Action& action);
void add_bench_lights(CLI::App& bench, CommonOptions& common, Action& action);
void add_bench_materials(CLI::App& bench, CommonOptions& common, Action& action);
void add_bench_measured(CLI::App& bench, CommonOptions& common, Action& action);
void add_bench_mixture(CLI::App& bench, CommonOptions& common, Action& action);
void add_bench_noise(CLI::App& bench, CommonOptions& common, Action& action);
void add_bench_paper(CLI::App& bench, CommonOptions& common, Action& action);
void add_bench_peers(CLI::App& bench, CommonOptions& common, Action& action);
void add_bench_rays(CLI::App& bench, CommonOptions& common, Action& action);
void add_bench_shading(CLI::App& bench, CommonOptions& common, Action& action);
void add_bench_speed_error(CLI::App& bench, CommonOptions& common, Action& action);
void add_bench_triangles(CLI::App& bench, CommonOptions& common, Action& action);
void add_bench_window(CLI::App& bench, CommonOptions& common, Action& action);

// Adds a benchmark's verb with --json and --into; `run` makes the report when the command line is read.
CLI::App* add_benchmark(CLI::App& bench, const char* name, const char* what, CommonOptions& common, Action& action,
                        std::function<Result<Report>()> run);

}  // namespace vamp
