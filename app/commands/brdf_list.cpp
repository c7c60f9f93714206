// `vamp brdf list`: the registry.
#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include "app/commands/brdf.h"
#include "engine/brdf/registry.h"
#include "engine/core/json.h"

namespace vamp {
namespace {

Json parameter_json(const ParameterRow& row, const ModelRow& model) {
  const bool degrees = row.display_factor() != 1;
  Json json;
  json["column"] = fmt::format("p{}", row.slot);
  json["name"] = row.name;
  json["label"] = row.label;
  json["tooltip"] = row.tooltip;
  json["unit"] = degrees ? "rad" : row.unit;
  json["display_unit"] = row.unit;
  json["display_factor"] = json_number(row.display_factor());
  json["min"] = json_number(row.min);
  json["max"] = json_number(row.max);
  json["default"] = json_number(row.fallback);
  json["mapping"] = name_of(row.mapping);
  json["hidden"] = row.hidden;
  json["citation"] = row.citation;
  json["variants"] = Json::array();
  for (uint8_t v = 0; v < model.variants.size(); ++v)
    if (row.belongs_to(v)) json["variants"].push_back(model.variants[v].name);
  return json;
}

Json models_json() {
  Json list = Json::array();
  for (const ModelRow& model : models()) {
    Json json;
    json["name"] = model.name;
    json["label"] = model.label;
    json["tooltip"] = model.tooltip;
    json["default_variant"] = model.variants[model.default_variant].name;
    for (const VariantRow& variant : model.variants) {
      json["variants"].push_back(Json{{"name", variant.name},
                                      {"label", variant.label},
                                      {"tooltip", variant.tooltip},
                                      {"citation", variant.citation}});
    }
    for (const ParameterRow& row : model.parameters) json["parameters"].push_back(parameter_json(row, model));
    list.push_back(std::move(json));
  }
  return Json{{"models", std::move(list)}};
}

std::string models_text() {
  std::string text;
  for (const ModelRow& model : models()) {
    text += fmt::format("{} ({}). {}\n", model.name, model.label, model.tooltip);
    for (uint8_t v = 0; v < model.variants.size(); ++v) {
      const VariantRow& variant = model.variants[v];
      text += fmt::format("  /{:<22} {}{} [{}]\n", variant.name, variant.tooltip,
                          v == model.default_variant ? " The usual one." : "", variant.citation);
    }
    for (const ParameterRow& row : model.parameters) {
      std::string only;
      for (uint8_t v = 0; v < model.variants.size(); ++v)
        if (row.belongs_to(v)) only += fmt::format("{}{}", only.empty() ? "" : ", ", model.variants[v].name);
      const float factor = row.display_factor();
      text += fmt::format("  p{} {:<20} {:g} to {:g}{}, {:g}. {}: {} [{}]{}\n", row.slot, row.name, row.min * factor,
                          row.max * factor, factor != 1 ? " " + std::string(row.unit) : "", row.fallback * factor,
                          row.label, row.tooltip, row.citation, row.variants == ~0u ? "" : " (" + only + ")");
    }
  }
  return text;
}

}  // namespace

void add_brdf_list(CLI::App& brdf, CommonOptions& common, Action& action) {
  CLI::App* verb = brdf.add_subcommand("list", "List models, variants and parameters");
  verb->add_flag("--json", common.json, "Print it as JSON; ranges in the measure of p0..p5, angles in radians");
  verb->callback([&common, &action] {
    action = [&common]() -> Status {
      fmt::print("{}", common.json ? print_json(models_json()) : models_text());
      return {};
    };
  });
}

}  // namespace vamp
