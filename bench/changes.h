#pragma once
// Materials that really change and the edits that should show the same: what `vamp bench edits` measures.
#include <functional>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "engine/material/edit_layer.h"
#include "engine/material/pigments.h"

namespace vamp {

// Settings of a mesostructure (vamp acquire --list --meso NAME).
using MesoSettings = std::vector<std::pair<std::string, std::variant<float, vec3>>>;

struct Change {
  std::string name;  // "calf, finish taken off"
  std::string edit;  // what is done in the editor, in a line
  std::string meso;
  MesoSettings before, after;                  // both over the mesostructure's own
  std::function<EditLayer(const Spmm&)> make;  // by the edit layer alone
  std::optional<PigmentChange> pigment;        // where a colour is exchanged: what `vamp recolour` is told
};
std::vector<Change> changes();

// The edits, as a designer makes them: over every cluster, without knowledge of how the material was made.

// A pigment for another by gains: the weights that a function has in a cluster are together seen as a mixture of
// colours.
EditLayer recoloured(const Spmm& spmm, const PigmentChange& change);
// Functions that shine (all but Lambert's and Oren-Nayar's) times a gain: 0 takes the finish off.
EditLayer with_gloss(const Spmm& spmm, float gain);
// Their widths times a factor.
EditLayer with_roughness(const Spmm& spmm, float factor);
// The slopes of all normals times a factor.
EditLayer with_relief(const Spmm& spmm, float factor);

}  // namespace vamp
