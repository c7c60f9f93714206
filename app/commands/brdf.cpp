#include "app/commands/brdf.h"

#include <CLI/CLI.hpp>

namespace vamp {

void add_brdf(CLI::App& app, CommonOptions& common, Action& action) {
  CLI::App* verb = app.add_subcommand("brdf", "Evaluate, sample and plot the BRDF models");
  verb->require_subcommand(1);
  add_brdf_list(*verb, common, action);
  add_brdf_eval(*verb, common, action);
  add_brdf_sample(*verb, common, action);
  add_brdf_albedo(*verb, common, action);
  add_brdf_plot(*verb, common, action);
}

}  // namespace vamp
