#include "engine/image/compare.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "app/commands/command.h"
#include "app/commands/option_values.h"
#include "engine/project/limits.h"

namespace vamp {

void add_compare(CLI::App& app, CommonOptions& common, Action& action) {
  struct Options {
    std::string a, b, exposure;
  };
  auto options = std::make_shared<Options>();
  CLI::App* verb = app.add_subcommand("compare", "Say how far a picture is from a reference: RMSE, relMSE, MSSIM");
  verb->add_option("a", options->a, "Picture: .png, .jpg, .exr or .hdr")->type_name("FILE")->required();
  verb->add_option("b", options->b, "The reference, of the same size and kind")->type_name("REFERENCE")->required();
  verb->add_option("--exposure", options->exposure, "Stops, for MSSIM and PSNR of linear pictures; 0 by default")
      ->type_name("STOPS");
  verb->add_flag("--json", common.json, "Print the figures as JSON");
  verb->callback([options, &common, &action] {
    action = [options, &common]() -> Status {
      float exposure = 0;
      if (!options->exposure.empty()) {
        VAMP_TRY(exposure, number_option(options->exposure, "--exposure", -kMaxExposure, kMaxExposure));
      }
      VAMP_TRY(const CompareReport report, compare_files(options->a, options->b, exposure));
      fmt::print("{}", common.json ? compare_json(report) : compare_text(report));
      return {};
    };
  });
}

}  // namespace vamp
