#pragma once
// A parameter of a BRDF model as a row of the panel. Everything it says comes from the registry.
#include <string>

#include "editor/widgets/number.h"
#include "engine/brdf/registry.h"

namespace vamp::ui {

// Keeps the texts that the widget points to.
struct RegistryRow {
  std::string label, description, unit, format;
  float factor = 1;  // displayed = stored * factor
  float low = 0, high = 1;
  const Mapping* mapping = &kLinear;

  explicit RegistryRow(const ParameterRow& row);

  // `initial` in the lobe's own measure.
  Parameter parameter(float initial) const;
};

// "Stretched gloss (Energy-conserving)"; without the variant where the model has only one.
std::string model_text(const Lobe& lobe);

}  // namespace vamp::ui
