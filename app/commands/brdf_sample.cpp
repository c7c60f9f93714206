// `vamp brdf sample`: draws of one lobe, or of a table of them.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <random>

#include "app/commands/brdf.h"
#include "app/commands/brdf_table.h"
#include "app/commands/interrupt.h"
#include "app/commands/option_values.h"
#include "app/commands/text_output.h"
#include "engine/core/jobs.h"
#include "engine/core/progress.h"

namespace vamp {
namespace {

constexpr size_t kBatch = 1 << 16;  // draws in memory at once
constexpr const char* kAnswers = "wi_x,wi_y,wi_z,pdf,weight,valid";

struct Options {
  LobeWords lobe;
  std::string in, out = "-", on, theta = "45", phi = "0", count = "1000", seed = "1";
};

std::string answer_text(const BrdfEngine& engine, const BrdfEngine::Draw& d) {
  return fmt::format("{},{},{},{},{},{}\n", engine.print(d.wi.x), engine.print(d.wi.y), engine.print(d.wi.z),
                     engine.print(d.pdf), engine.print(d.weight), d.valid ? 1 : 0);
}

// Takes questions with the text that precedes their answers and writes both, a batch at a time.
class Answers {
 public:
  Answers(BrdfEngine& engine, TextOutput& output) : engine_(engine), output_(output) {}

  Status add(std::string line, const BrdfQuestion& question) {
    lines_.push_back(std::move(line));
    questions_.push_back(question);
    return questions_.size() < kBatch ? Status{} : flush();
  }

  Status flush() {
    const std::vector<BrdfEngine::Draw> draws = engine_.draws(questions_);
    for (size_t i = 0; i < draws.size(); ++i)
      VAMP_CHECK_STATUS(output_.write(lines_[i] + ',' + answer_text(engine_, draws[i])));
    lines_.clear();
    questions_.clear();
    return {};
  }

 private:
  BrdfEngine& engine_;
  TextOutput& output_;
  std::vector<std::string> lines_;
  std::vector<BrdfQuestion> questions_;
};

Status sample_table(BrdfTable& table, BrdfEngine& engine, TextOutput& output, Progress& progress) {
  VAMP_CHECK_STATUS(output.write(table.header() + ',' + kAnswers + '\n'));
  Answers answers(engine, output);
  BrdfTable::Row row;
  for (;;) {
    VAMP_TRY(const bool more, table.next(row));
    if (!more) break;
    const auto& n = row.numbers;
    for (const size_t u : {size_t{3}, size_t{4}})
      if (!(n[u] >= 0 && n[u] < 1)) return table.refuse(u == 3 ? "u0" : "u1", "0 to below 1", fmt::format("{}", n[u]));
    VAMP_CHECK_STATUS(answers.add(row.text, {row.lobe, vec3(0, 0, 1), vec3(n[0], n[1], n[2]), vec2(n[3], n[4])}));
    progress.fraction(table.fraction());
    if (progress.cancelled()) return JobQueue::cancelled_error();
  }
  VAMP_CHECK_STATUS(answers.flush());
  return output.finish();
}

Status sample_lobes(const BrdfQuestion& question, uint32_t count, uint32_t seed, BrdfEngine& engine, TextOutput& output,
                    Progress& progress) {
  VAMP_CHECK_STATUS(output.write(std::string("u0,u1,") + kAnswers + '\n'));
  std::mt19937 bits(seed);
  const auto uniform = [&bits] { return static_cast<float>(bits() >> 8) * 0x1p-24f; };
  Answers answers(engine, output);
  for (uint32_t i = 0; i < count; ++i) {
    BrdfQuestion drawn = question;
    drawn.u.x = uniform();
    drawn.u.y = uniform();
    VAMP_CHECK_STATUS(answers.add(fmt::format("{},{}", drawn.u.x, drawn.u.y), drawn));
    progress.fraction(static_cast<float>(i) / static_cast<float>(count));
    if (progress.cancelled()) return JobQueue::cancelled_error();
  }
  VAMP_CHECK_STATUS(answers.flush());
  return output.finish();
}

Status sample(const Options& options, const CommonOptions& common) {
  if (options.in.empty() == options.lobe.model.empty())
    return fail(ErrorKind::usage, "", "sample", "either a model or --in", options.in.empty() ? "neither" : "both");
  catch_interrupts();
  Progress progress;
  Status status;
  if (!options.in.empty()) {
    VAMP_TRY(BrdfTable table, BrdfTable::open(options.in, {"wo_x", "wo_y", "wo_z", "u0", "u1"},
                                              {"wi_x", "wi_y", "wi_z", "pdf", "weight", "valid"}));
    VAMP_TRY(TextOutput output, TextOutput::open(options.out));
    VAMP_TRY(BrdfEngine engine, BrdfEngine::open(options.on, common));
    run_with_progress("drawing", progress, [&] { status = sample_table(table, engine, output, progress); });
    return status;
  }
  VAMP_TRY(const Lobe lobe, lobe_of(options.lobe));
  VAMP_TRY(const float theta, number_option(options.theta, "--theta", 0, kMaxTheta));
  VAMP_TRY(const float phi, number_option(options.phi, "--phi", -360, 360));
  VAMP_TRY(const uint32_t count, count_option(options.count, "--count", 1, 1'000'000'000));
  VAMP_TRY(const uint32_t seed, count_option(options.seed, "--seed", 0, UINT32_MAX));
  VAMP_TRY(TextOutput output, TextOutput::open(options.out));
  VAMP_TRY(BrdfEngine engine, BrdfEngine::open(options.on, common));
  const BrdfQuestion question{.lobe = lobe, .wo = direction_at(static_cast<double>(theta), static_cast<double>(phi))};
  run_with_progress("drawing", progress,
                    [&] { status = sample_lobes(question, count, seed, engine, output, progress); });
  return status;
}

}  // namespace

void add_brdf_sample(CLI::App& brdf, CommonOptions& common, Action& action) {
  auto options = std::make_shared<Options>();
  CLI::App* verb = brdf.add_subcommand("sample", "Draw lights for a viewer as the model's sampler does");
  add_lobe_words(*verb, options->lobe, false);
  verb->add_option("--theta", options->theta, "The viewer's angle from the normal")
      ->type_name("DEGREES")
      ->capture_default_str();
  verb->add_option("--phi", options->phi, "And about it, from x towards y")
      ->type_name("DEGREES")
      ->capture_default_str();
  verb->add_option("--count", options->count, "Number of draws")->type_name("N")->capture_default_str();
  verb->add_option("--seed", options->seed, "Of the random numbers")->type_name("N")->capture_default_str();
  verb->add_option("--in", options->in,
                   "Instead of a model: CSV with the columns model,variant,p0..p5,wo_x,wo_y,wo_z,u0,u1; - is standard "
                   "input")
      ->type_name("FILE");
  verb->add_option("--out", options->out, fmt::format("CSV: u0, u1 or the table, then {}", kAnswers))
      ->type_name("FILE")
      ->capture_default_str();
  add_engine_option(*verb, options->on);
  verb->footer(
      "pdf is per steradian, weight is fcos / pdf. Draws that fell below the horizon have valid 0 and count as "
      "samples\n"
      "of value 0: the sum of weight over valid draws, divided by the number of all draws, is the albedo.");
  verb->callback([options, &common, &action] { action = [options, &common] { return sample(*options, common); }; });
}

}  // namespace vamp
