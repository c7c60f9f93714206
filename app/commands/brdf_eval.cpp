// `vamp brdf eval`: a table of questions, answered row by row.
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "app/commands/brdf.h"
#include "app/commands/brdf_table.h"
#include "app/commands/interrupt.h"
#include "app/commands/text_output.h"
#include "engine/core/jobs.h"
#include "engine/core/progress.h"

namespace vamp {
namespace {

constexpr size_t kBatch = 1 << 16;  // rows in memory at once

struct Options {
  std::string in = "-", out = "-", on;
  bool pdf = false;
};

Status answer(const Options& options, BrdfEngine& engine, BrdfTable& table, TextOutput& output, Progress& progress) {
  VAMP_CHECK_STATUS(output.write(table.header() + ",f,fcos" + (options.pdf ? ",pdf\n" : "\n")));
  std::vector<std::string> lines;
  std::vector<BrdfQuestion> questions;
  BrdfTable::Row row;
  for (bool more = true; more;) {
    lines.clear();
    questions.clear();
    while (questions.size() < kBatch) {
      VAMP_TRY(more, table.next(row));
      if (!more) break;
      const auto& n = row.numbers;
      lines.push_back(row.text);
      questions.push_back({row.lobe, vec3(n[0], n[1], n[2]), vec3(n[3], n[4], n[5])});
    }
    const std::vector<BrdfEngine::Value> values = engine.values(questions);
    for (size_t i = 0; i < values.size(); ++i) {
      const double fcos = values[i].fcos;
      std::string& line = lines[i];
      // The length of a direction that was not a unit vector plays no part in its cosine.
      const double f = fcos == 0 ? 0 : fcos / static_cast<double>(unit_direction(questions[i].wi).z);
      line += ',' + engine.print(f) + ',' + engine.print(fcos);
      if (options.pdf) line += ',' + engine.print(values[i].pdf);
      line += '\n';
      VAMP_CHECK_STATUS(output.write(line));
    }
    progress.fraction(table.fraction());
    if (progress.cancelled()) return JobQueue::cancelled_error();
  }
  return output.finish();
}

Status eval(const Options& options, const CommonOptions& common) {
  catch_interrupts();
  VAMP_TRY(BrdfTable table, BrdfTable::open(options.in, {"wi_x", "wi_y", "wi_z", "wo_x", "wo_y", "wo_z"},
                                            {"f", "fcos", options.pdf ? "pdf" : "f"}));
  VAMP_TRY(TextOutput output, TextOutput::open(options.out));
  VAMP_TRY(BrdfEngine engine, BrdfEngine::open(options.on, common));
  Progress progress;
  Status status;
  run_with_progress("evaluating", progress, [&] { status = answer(options, engine, table, output, progress); });
  return status;
}

}  // namespace

void add_brdf_eval(CLI::App& brdf, CommonOptions& common, Action& action) {
  auto options = std::make_shared<Options>();
  CLI::App* verb = brdf.add_subcommand("eval", "Evaluate a table of BRDFs and directions");
  verb->add_option("--in", options->in,
                   "CSV with the columns model,variant,p0..p5,wi_x,wi_y,wi_z,wo_x,wo_y,wo_z; - is standard input")
      ->type_name("FILE")
      ->capture_default_str();
  verb->add_option("--out", options->out, "The same with f (1/sr, without the cosine) and fcos appended")
      ->type_name("FILE")
      ->capture_default_str();
  add_engine_option(*verb, options->on);
  verb->add_flag("--pdf", options->pdf, "Append pdf too: the density of the model's sampler at wi, per steradian");
  verb->footer(
      "wi points to the light, wo to the viewer, z is the normal. p0..p5 are the parameters in the order of\n"
      "`vamp brdf list`, angles in radians, 0 where the model has none. Numbers are read as the nearest floats;\n"
      "directions longer or shorter than 1 by more than a millionth are normalised. f is 0 unless both directions are\n"
      "above the horizon; nothing is clamped. Columns may stand in any order; others are passed on.");
  verb->callback([options, &common, &action] { action = [options, &common] { return eval(*options, common); }; });
}

}  // namespace vamp
