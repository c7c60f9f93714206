#include "editor/panels/registry_rows.h"

#include "editor/panels/lengths.h"

namespace vamp::ui {

namespace {

const Mapping& mapping_of(const ParameterRow& row) {
  switch (row.mapping) {
    case vamp::Mapping::linear:
      return kLinear;
    case vamp::Mapping::square:
      return kSquare;
    case vamp::Mapping::logarithmic:
      break;
  }
  return row.min > 0 ? kLog : kLogFromZero;
}

const char* format_of(const ParameterRow& row) {
  if (row.unit == "deg") return "%.1f°";
  return row.max > 100 ? "%.4g" : "%.3f";
}

}  // namespace

RegistryRow::RegistryRow(const ParameterRow& row)
    : label(row.label),
      description(std::string(row.tooltip) + "\n" + std::string(row.citation)),
      unit(row.unit == "deg" ? "degrees"
           : row.unit == "1" ? ""
                             : row.unit),
      format(format_of(row)),
      factor(row.display_factor()),
      low(row.min * factor),
      high(row.max * factor),
      mapping(&mapping_of(row)) {}

Parameter RegistryRow::parameter(float initial) const {
  Parameter made{label.c_str(),       low,          high,   initial * factor, format.c_str(),
                 description.c_str(), unit.c_str(), mapping};
  return made;
}

std::string model_text(const Lobe& lobe) {
  const ModelRow& row = model_row(lobe.model);
  std::string text(row.label);
  if (row.variants.size() > 1 && lobe.variant < row.variants.size()) {
    text += " (" + std::string(row.variants[lobe.variant].label) + ")";
  }
  return text;
}

}  // namespace vamp::ui
