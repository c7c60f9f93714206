#include "engine/brdf/registry.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "engine/brdf/registry_rows.h"

namespace vamp {

std::string_view name_of(Mapping mapping) {
  switch (mapping) {
    case Mapping::linear:
      return "linear";
    case Mapping::logarithmic:
      return "logarithmic";
    case Mapping::square:
      return "square";
  }
  return "";
}

float ParameterRow::display_factor() const { return unit == "deg" ? static_cast<float>(180 / std::numbers::pi) : 1; }

std::span<const ModelRow> models() { return kModelRows; }

const ModelRow& model_row(Model model) { return kModelRows[static_cast<size_t>(model)]; }

std::optional<Model> find_model(std::string_view name) {
  for (const ModelRow& row : kModelRows) {
    if (row.name == name) return row.model;
  }
  return std::nullopt;
}

std::optional<uint8_t> find_variant(Model model, std::string_view name) {
  const auto variants = model_row(model).variants;
  for (size_t v = 0; v < variants.size(); ++v) {
    if (variants[v].name == name) return static_cast<uint8_t>(v);
  }
  return std::nullopt;
}

const ParameterRow* find_parameter(Model model, uint8_t variant, std::string_view name) {
  for (const ParameterRow& row : model_row(model).parameters) {
    if (row.belongs_to(variant) && row.name == name) return &row;
  }
  return nullptr;
}

const ParameterRow* find_parameter(Model model, uint8_t variant, int slot) {
  for (const ParameterRow& row : model_row(model).parameters) {
    if (row.belongs_to(variant) && row.slot == slot) return &row;
  }
  return nullptr;
}

Lobe default_lobe(Model model) { return default_lobe(model, model_row(model).default_variant); }

Lobe default_lobe(Model model, uint8_t variant) {
  Lobe lobe{model, variant, {}};
  for (const ParameterRow& row : model_row(model).parameters) {
    if (row.belongs_to(variant)) lobe.params[row.slot] = row.fallback;
  }
  return lobe;
}

Lobe with_variant(const Lobe& lobe, uint8_t variant) {
  Lobe changed = default_lobe(lobe.model, variant);
  for (const ParameterRow& row : model_row(lobe.model).parameters) {
    if (!row.belongs_to(variant) || row.hidden) continue;
    const ParameterRow* before = find_parameter(lobe.model, lobe.variant, row.name);
    if (before == nullptr || before->hidden) continue;
    changed.params[row.slot] = std::clamp(lobe.params[before->slot], row.min, row.max);
  }
  return changed;
}

Status validate(const Lobe& lobe, std::string_view file, std::string_view place) {
  if (static_cast<size_t>(lobe.model) >= kModelRows.size()) {
    return fail(ErrorKind::bad_input, file, place, "one of 7 BRDF models",
                std::to_string(static_cast<int>(lobe.model)));
  }
  const ModelRow& model = model_row(lobe.model);
  if (lobe.variant >= model.variants.size()) {
    return fail(ErrorKind::bad_input, file, place,
                fmt::format("one of {} variants of {}", model.variants.size(), model.name),
                std::to_string(lobe.variant));
  }
  for (int slot = 0; slot < static_cast<int>(lobe.params.size()); ++slot) {
    const float value = lobe.params[static_cast<size_t>(slot)];
    const ParameterRow* row = find_parameter(lobe.model, lobe.variant, slot);
    const std::string where = fmt::format("{}.{}", place, row ? row->name : "params");
    if (!row) {
      if (value != 0)
        return fail(ErrorKind::bad_input, file, where, "0 where the model has no parameter", fmt::to_string(value));
      continue;
    }
    // Files say degrees rounded to a few digits: the end of the range must survive the way there and back.
    const float slack = 1e-6f * (row->max - row->min);
    if (!(value >= row->min - slack && value <= row->max + slack)) {
      const float factor = row->display_factor();
      return fail(
          ErrorKind::bad_input, file, where,
          fmt::format("{:.6g} to {:.6g}{}", row->min * factor, row->max * factor, row->unit == "deg" ? " deg" : ""),
          fmt::format("{:.6g}", value * factor));
    }
  }
  return {};
}

float to_slider(const ParameterRow& row, float value) {
  const double low = row.min, high = row.max;
  const double v = std::clamp(static_cast<double>(value), low, high);
  switch (row.mapping) {
    case Mapping::linear:
      return static_cast<float>((v - low) / (high - low));
    case Mapping::square:
      return static_cast<float>(std::sqrt((v - low) / (high - low)));
    case Mapping::logarithmic:
      break;
  }
  const double shift = low > 0 ? 0 : 1;
  return static_cast<float>(std::log((v + shift) / (low + shift)) / std::log((high + shift) / (low + shift)));
}

float from_slider(const ParameterRow& row, float position) {
  const double low = row.min, high = row.max;
  const double t = std::clamp(static_cast<double>(position), 0.0, 1.0);
  double value = low;
  switch (row.mapping) {
    case Mapping::linear:
      value = low + t * (high - low);
      break;
    case Mapping::square:
      value = low + t * t * (high - low);
      break;
    case Mapping::logarithmic: {
      const double shift = low > 0 ? 0 : 1;
      value = (low + shift) * std::pow((high + shift) / (low + shift), t) - shift;
    }
  }
  // pow may miss an end by a rounding.
  return std::clamp(static_cast<float>(value), row.min, row.max);
}

}  // namespace vamp
