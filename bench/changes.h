#pragma once
// Materials that really change and the edits that should show the same: what `vamp bench edits` measures.
#include <functional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "engine/material/edit_layer.h"

namespace vamp {

// Settings of a mesostructure (vamp acquire --list --meso NAME).
using MesoSettings = std::vector<std::pair<std::string, std::variant<float, vec3>>>;

struct Change {
  std::string name;  // "calf, finish taken off"
  std::string edit;  // what is done in the editor, in a line
  std::string meso;
  MesoSettings before, after;  // both over the mesostructure's own
  std::function<EditLayer(const Spmm&)> make;
};
std::vector<Change> changes();

// The edits, as a designer makes them: over every cluster, without knowledge of how the material was made.

// A pigment for another: each function's weights are seen as a mixture of `from` and of colours that stay, and what is
// `from` in them becomes `to`.
EditLayer recoloured(const Spmm& spmm, vec3 from, vec3 to, const std::vector<vec3>& staying);
// Functions that shine (all but Lambert's and Oren-Nayar's) times a gain: 0 takes the finish off.
EditLayer with_gloss(const Spmm& spmm, float gain);
// Their widths times a factor.
EditLayer with_roughness(const Spmm& spmm, float factor);
// The slopes of all normals times a factor.
EditLayer with_relief(const Spmm& spmm, float factor);

}  // namespace vamp
