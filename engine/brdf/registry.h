#pragma once
// The seven models, their variants and their parameters, said once: the editor's sliders, the preset reader, the fit
// and the command line read these rows and nothing else.
#include <optional>
#include <span>
#include <string_view>

#include "engine/brdf/lobe.h"
#include "engine/core/error.h"

namespace vamp {

// How a slider position in [0,1] becomes a value between min and max.
enum class Mapping : uint8_t {
  linear,
  logarithmic,  // equal steps multiply: by the value, or by 1 + value when the range starts at 0
  square,       // value - min grows with the square of the position: finer steps near min
};
std::string_view name_of(Mapping mapping);

// One parameter of one model. Angles are radians in a Lobe and degrees wherever a person sees them.
struct ParameterRow {
  std::string_view name;     // in files and on the command line
  std::string_view label;    // the designer's name
  std::string_view unit;     // as displayed: "deg", "1" for a plain ratio
  std::string_view tooltip;  // one sentence: what the slider does
  float min, max, fallback;  // in the Lobe's own measure (radians)
  Mapping mapping;
  std::string_view citation;
  uint8_t slot;       // which of Lobe::params
  uint32_t variants;  // bit v set: the row belongs to variant v
  bool hidden;        // in SPMM it stays at `fallback`, because weights carry scale and colour

  bool belongs_to(uint8_t variant) const { return ((variants >> variant) & 1u) != 0; }
  // Displayed value = stored value * display_factor() (180 / pi for "deg", else 1).
  float display_factor() const;
};

struct VariantRow {
  std::string_view name, label, tooltip, citation;
};

struct ModelRow {
  Model model;
  std::string_view name, label, tooltip;
  std::span<const ParameterRow> parameters;  // of all variants, in the papers' order; see belongs_to
  std::span<const VariantRow> variants;      // position = Lobe::variant
  uint8_t default_variant;
};

std::span<const ModelRow> models();
const ModelRow& model_row(Model model);
std::optional<Model> find_model(std::string_view name);
std::optional<uint8_t> find_variant(Model model, std::string_view name);

// The row of a parameter by its name or by its slot, for one variant; nullptr where the variant has no such parameter.
const ParameterRow* find_parameter(Model model, uint8_t variant, std::string_view name);
const ParameterRow* find_parameter(Model model, uint8_t variant, int slot);

// Every parameter at its fallback, unused ones 0.
Lobe default_lobe(Model model);
Lobe default_lobe(Model model, uint8_t variant);

// The same look under another variant as far as parameters allow: shared parameters stay, new ones take their fallback.
Lobe with_variant(const Lobe& lobe, uint8_t variant);

// Model and variant known, every parameter finite and within its row. The error names `file` and `place`.
Status validate(const Lobe& lobe, std::string_view file, std::string_view place);

// Slider position in [0,1] from a value and back; values outside the range go to the nearest end.
float to_slider(const ParameterRow& row, float value);
float from_slider(const ParameterRow& row, float position);

}  // namespace vamp
