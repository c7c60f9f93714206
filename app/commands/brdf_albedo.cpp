// `vamp brdf albedo`: how much of the light a lobe sends back, by viewer.
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "app/commands/brdf.h"
#include "app/commands/brdf_table.h"
#include "app/commands/interrupt.h"
#include "app/commands/option_values.h"
#include "app/commands/text_output.h"
#include "engine/brdf/registry.h"
#include "engine/core/jobs.h"
#include "engine/core/json.h"
#include "engine/core/progress.h"

namespace vamp {
namespace {

struct Options {
  LobeWords lobe;
  std::string in, out = "-", on, theta = "0,15,30,45,60,75,80,85,88,89,89.5,89.9", phi = "0", side = "256";
};

// The mean weight of the sampler over midpoints of side x side cells of its square: the sampler makes the lobe a smooth
// function there, but for the curve beyond which draws fall below the horizon.
class Quadrature {
 public:
  Quadrature(BrdfEngine& engine, uint32_t side) : engine_(engine), side_(side) {}

  double albedo(const Lobe& lobe, vec3 wo) {
    const auto middle = [this](uint32_t k) { return (static_cast<float>(k) + 0.5f) / static_cast<float>(side_); };
    double sum = 0;
    std::vector<BrdfQuestion> row;
    for (uint32_t y = 0; y < side_; ++y) {
      row.clear();
      for (uint32_t x = 0; x < side_; ++x) row.push_back({.lobe = lobe, .wo = wo, .u = vec2(middle(x), middle(y))});
      for (const BrdfEngine::Draw& d : engine_.draws(row)) sum += d.valid ? d.weight : 0;
    }
    return sum / (static_cast<double>(side_) * side_);
  }

 private:
  BrdfEngine& engine_;
  uint32_t side_;
};

Status albedo_table(BrdfTable& table, const BrdfEngine& engine, Quadrature& quadrature, TextOutput& output,
                    Progress& progress) {
  VAMP_CHECK_STATUS(output.write(table.header() + ",albedo\n"));
  BrdfTable::Row row;
  for (;;) {
    VAMP_TRY(const bool more, table.next(row));
    if (!more) return output.finish();
    const auto& n = row.numbers;
    VAMP_CHECK_STATUS(output.write(
        row.text + ',' + engine.print(quadrature.albedo(row.lobe, unit_direction(vec3(n[0], n[1], n[2])))) + '\n'));
    progress.fraction(table.fraction());
    if (progress.cancelled()) return JobQueue::cancelled_error();
  }
}

Status albedo(const Options& options, const CommonOptions& common) {
  if (options.in.empty() == options.lobe.model.empty())
    return fail(ErrorKind::usage, "", "albedo", "either a model or --in", options.in.empty() ? "neither" : "both");
  catch_interrupts();
  VAMP_TRY(const uint32_t side, count_option(options.side, "--side", 1, 8192));
  Progress progress;
  if (!options.in.empty()) {
    VAMP_TRY(BrdfTable table, BrdfTable::open(options.in, {"wo_x", "wo_y", "wo_z"}, {"albedo"}));
    VAMP_TRY(TextOutput output, TextOutput::open(options.out));
    VAMP_TRY(BrdfEngine engine, BrdfEngine::open(options.on, common));
    Quadrature quadrature(engine, side);
    Status status;
    run_with_progress("integrating", progress,
                      [&] { status = albedo_table(table, engine, quadrature, output, progress); });
    return status;
  }
  VAMP_TRY(const Lobe lobe, lobe_of(options.lobe));
  VAMP_TRY(const std::vector<double> thetas, angles_option(options.theta, "--theta"));
  VAMP_TRY(const float phi, number_option(options.phi, "--phi", -360, 360));
  VAMP_TRY(TextOutput output, TextOutput::open(options.out));
  VAMP_TRY(BrdfEngine engine, BrdfEngine::open(options.on, common));
  Quadrature quadrature(engine, side);
  std::string text = "theta,albedo\n";
  Json list = Json::array();
  run_with_progress("integrating", progress, [&] {
    for (const double theta : thetas) {
      if (progress.cancelled()) return;
      const double value = quadrature.albedo(lobe, direction_at(theta, static_cast<double>(phi)));
      text += fmt::format("{:.6g},{:.6f}\n", theta, value);
      list.push_back(Json{{"theta", json_number(static_cast<float>(theta))}, {"albedo", value}});
      progress.fraction(static_cast<float>(list.size()) / static_cast<float>(thetas.size()));
    }
  });
  if (progress.cancelled()) return JobQueue::cancelled_error();
  VAMP_CHECK_STATUS(output.write(common.json ? print_json(list) : text));
  return output.finish();
}

}  // namespace

void add_brdf_albedo(CLI::App& brdf, CommonOptions& common, Action& action) {
  auto options = std::make_shared<Options>();
  CLI::App* verb = brdf.add_subcommand("albedo", "Say how much of the light is sent back, by viewer");
  add_lobe_words(*verb, options->lobe, false);
  verb->add_option("--theta", options->theta, "The viewer's angles from the normal")
      ->type_name("DEGREES")
      ->capture_default_str();
  verb->add_option("--phi", options->phi, "And about it, from x towards y")
      ->type_name("DEGREES")
      ->capture_default_str();
  verb->add_option("--side", options->side, "Midpoints a side of the sampler's square")
      ->type_name("N")
      ->capture_default_str();
  verb->add_option("--in", options->in,
                   "Instead of a model: CSV with the columns model,variant,p0..p5,wo_x,wo_y,wo_z; - is standard input")
      ->type_name("FILE");
  verb->add_option("--out", options->out, "CSV: theta,albedo, or the table with albedo appended")
      ->type_name("FILE")
      ->capture_default_str();
  add_engine_option(*verb, options->on);
  verb->add_flag("--json", common.json, "Print the list as JSON");
  verb->footer("Albedo is the integral of f times the light's cosine over the hemisphere of lights.");
  verb->callback([options, &common, &action] { action = [options, &common] { return albedo(*options, common); }; });
}

}  // namespace vamp
