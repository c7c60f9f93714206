// `vamp recolour`: one colour of a fitted material for another.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <cmath>

#include "app/commands/colour_option.h"
#include "app/commands/command.h"
#include "app/commands/preset_output.h"
#include "engine/core/json.h"
#include "engine/fit/swatch.h"
#include "engine/image/save.h"
#include "engine/material/pigments.h"
#include "engine/material/preset.h"
#include "shaders/shared/tonemap.h"

namespace vamp {
namespace {

constexpr int kThumbnailSide = 256;

struct Options {
  std::string input, output, from, to, name;
  std::vector<std::string> keep;
};

// As it is told to people: white, black or #rrggbb.
std::string words(const vec3& colour) {
  if (colour == vec3(0)) return "black";
  if (colour == vec3(1)) return "white";
  const vec3 code = 255.f * srgb_encoded(colour);
  return fmt::format("#{:02x}{:02x}{:02x}", std::lround(code.x), std::lround(code.y), std::lround(code.z));
}

Result<PigmentChange> read_change(const Options& options) {
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
  return change;
}

Status recolour(const Options& options, const CommonOptions& common) {
  VAMP_CHECK_STATUS(check_preset_output(options.output, options.name));
  VAMP_TRY(const PigmentChange change, read_change(options));
  VAMP_TRY(Preset preset, load_preset(options.input));
  const PigmentShares shares = pigment_shares(*preset.fit, change);
  if (shares.texels == 0)
    return fail(ErrorKind::usage, options.input, "--from", "a colour that some texel has a hundredth of its light from",
                options.from);
  Spmm changed = with_pigment(*preset.fit, change);
  VAMP_TRY(preset.thumbnail_png, encode_png(fit::material_swatch(changed, kThumbnailSide, 2)));
  preset.fit = std::make_shared<const Spmm>(std::move(changed));
  // Not the old name: nobody could tell the two apart in a library.
  preset.name = !options.name.empty() ? options.name
                                      : fmt::format("{}, {} for {}", preset.name, words(change.to), words(change.from));
  preset.provenance += fmt::format("{}Recoloured by vamp recolour: {} for {}.", preset.provenance.empty() ? "" : " ",
                                   options.to, options.from);
  VAMP_CHECK_STATUS(save_preset(preset, options.output));
  if (common.json) {
    const auto number = [](double value) { return json_number(static_cast<float>(value)); };
    fmt::print("{}", print_json({{"file", options.output},
                                 {"name", preset.name},
                                 {"share_of_light", number(shares.light)},
                                 {"share_of_texels", number(shares.texels)},
                                 {"untold", number(shares.untold)}}));
  } else {
    fmt::print(
        "{}: \"{}\"\n{} gave {:.1f} % of the light, in {:.1f} % of the texels; {:.1f} % (relative RMSE) of the weights "
        "are no mixture of the colours that go and stay\n",
        options.output, preset.name, words(change.from), 100 * shares.light, 100 * shares.texels, 100 * shares.untold);
  }
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
  verb->add_option("--name", options->name, "Name of the new preset; the old one's and the colours by default")
      ->type_name("NAME");
  verb->add_option("-o,--output", options->output, "The new preset: a .vamp file, or a folder")
      ->type_name("PRESET")
      ->required();
  verb->add_flag("--json", common.json, "Print what was written as JSON");
  verb->callback([options, &common, &action] { action = [options, &common] { return recolour(*options, common); }; });
}

}  // namespace vamp
