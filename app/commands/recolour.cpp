// `vamp recolour`: one colour of a fitted material for another.
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "app/commands/colour_option.h"
#include "app/commands/command.h"
#include "engine/core/json.h"
#include "engine/fit/swatch.h"
#include "engine/image/save.h"
#include "engine/material/pigments.h"
#include "engine/material/preset.h"

namespace vamp {
namespace {

constexpr int kThumbnailSide = 256;

struct Options {
  std::string input, output, from, to, name;
  std::vector<std::string> keep;
};

Status recolour(const Options& options, const CommonOptions& common) {
  PigmentChange change;
  VAMP_TRY(change.from, colour_option(options.from, "--from"));
  VAMP_TRY(change.to, colour_option(options.to, "--to"));
  if (change.from == vec3(0)) return fail(ErrorKind::usage, "", "--from", "a colour that is not black", options.from);
  if (change.from != vec3(1)) change.staying.emplace_back(1);
  for (const std::string& text : options.keep) {
    VAMP_TRY(const vec3 colour, colour_option(text, "--keep"));
    if (colour == change.from)
      return fail(ErrorKind::usage, "", "--keep", "another colour than the one that goes (--from)", text);
    change.staying.push_back(colour);
  }
  VAMP_TRY(Preset preset, load_preset(options.input));
  Spmm changed = with_pigment(*preset.fit, change);
  VAMP_TRY(preset.thumbnail_png, encode_png(fit::material_swatch(changed, kThumbnailSide, 2)));
  preset.fit = std::make_shared<const Spmm>(std::move(changed));
  if (!options.name.empty()) preset.name = options.name;
  preset.provenance += fmt::format("{}Recoloured by vamp recolour: {} for {}.", preset.provenance.empty() ? "" : " ",
                                   options.to, options.from);
  VAMP_CHECK_STATUS(save_preset(preset, options.output));
  if (common.json) fmt::print("{}", print_json({{"file", options.output}, {"name", preset.name}}));
  return {};
}

}  // namespace

void add_recolour(CLI::App& app, CommonOptions& common, Action& action) {
  auto options = std::make_shared<Options>();
  CLI::App* verb = app.add_subcommand("recolour", "Exchange a colour of a fitted material for another");
  verb->add_option("preset", options->input, "The material: a .vamp file, or a folder")
      ->type_name("PRESET")
      ->required();
  verb->add_option("--from", options->from, "The colour that goes: R,G,B (linear), #rrggbb or white")
      ->type_name("COLOUR")
      ->required();
  verb->add_option("--to", options->to, "The colour that comes; black takes a white finish off")
      ->type_name("COLOUR")
      ->required();
  verb->add_option("--keep", options->keep, "A colour that stays, as white does, which highlights are; again for more")
      ->type_name("COLOUR")
      ->allow_extra_args(false);
  verb->add_option("--name", options->name, "Name of the new preset; the old one's by default")->type_name("NAME");
  verb->add_option("-o,--output", options->output, "The new preset: a .vamp file, or a folder")
      ->type_name("PRESET")
      ->required();
  verb->add_flag("--json", common.json, "Print what was written as JSON");
  verb->callback([options, &common, &action] { action = [options, &common] { return recolour(*options, common); }; });
}

}  // namespace vamp
